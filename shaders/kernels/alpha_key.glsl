// Key of the segment that `path` traces in this dispatch; constant where nothing has alpha.
AlphaKey alphaKeyOf(uint path, uint kind) {
    if (kHasAlpha == 0u) return AlphaKey(0u);
    bool camera = batch.bounce == 0u && kind == kRayPath;   // the same in all rounds
    uint round = kIntegrator == kIntegratorDirect && !camera ? batch.round : 0u;
    return makeAlphaKey(sampleIdOf(path), batch.bounce + round, kind);
}
