// The checks of rung 4. A batch of the scene is walked through once; each check shows the findings of one kernel.
#pragma once

namespace vkpt {

class VerifyContext;
class Findings;

void checkGenerate(VerifyContext&, Findings&);
void checkIntersect(VerifyContext&, Findings&);
void checkMiss(VerifyContext&, Findings&);
void checkShade(VerifyContext&, Findings&);
void checkShadow(VerifyContext&, Findings&);
void checkAccumulate(VerifyContext&, Findings&);
/// All kernels on a small scene in memory that has every feature.
void checkEveryFeature(VerifyContext&, Findings&);
/// The same of a scene that has every BSDF model, with interreflection.
void checkEveryBsdf(VerifyContext&, Findings&);

}  // namespace vkpt
