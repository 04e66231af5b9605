// Weight of a sample of density `pdf` against another strategy, of density `other`, each times its number of samples: the
// power heuristic. [Veach 97] Written as a ratio, so that no power overflows.
float misWeight(float pdf, float other, float beta) {
    float ratio = other / pdf;
    if (kBeta == 1u) return 1.0 / (1.0 + ratio);
    return 1.0 / (1.0 + (kBeta == 2u ? ratio * ratio : (ratio > 0.0 ? pow(ratio, beta) : 0.0)));
}
