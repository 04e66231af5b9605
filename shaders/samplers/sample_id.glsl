// What a sample value depends on, besides its dimension. `pixel` packs x | y << 16 in full-frame coordinates.
struct SampleId {
    uint pixel, index, spp, seed;
};
