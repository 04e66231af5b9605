// The film's layers beside the beauty: kLayerWords words a pixel, after the beauty's words of the whole band.
layout(set = 0, binding = 5, std430) restrict buffer FilmWords { uvec4 filmWords[]; };

// The first word of layers of pixel `pixel` of the batch.
uint layerBase(uint pixel) { return batch.filmLayers + (batch.firstPixel - batch.filmFirst + pixel) * kLayerWords; }
