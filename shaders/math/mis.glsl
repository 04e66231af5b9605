// Weight of a light sample, or of a BSDF sample with the arguments swapped: power heuristic, beta = 2. [Veach 97]
// Written as a ratio, so that no square overflows.
float powerHeuristic(float pdf, float other) {
    float ratio = other / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}
