// The checks of rungs 1 to 3. NAME's probe is shaders/probes/NAME.comp; its check stands in probes/NAME.cpp.
#pragma once

namespace vkpt {

class VerifyContext;
class Findings;

void checkLayout(VerifyContext&, Findings&);
void checkState(VerifyContext&, Findings&);
void checkSpecialization(VerifyContext&, Findings&);

void checkHash(VerifyContext&, Findings&);
void checkSamplers(VerifyContext&, Findings&);
void checkCdf(VerifyContext&, Findings&);
void checkFixedPoint(VerifyContext&, Findings&);
void checkFilmLayers(VerifyContext&, Findings&);
void checkAppend(VerifyContext&, Findings&);

void checkTrigonometry(VerifyContext&, Findings&);
void checkWarp(VerifyContext&, Findings&);
void checkFrame(VerifyContext&, Findings&);
void checkOctahedral(VerifyContext&, Findings&);
void checkColor(VerifyContext&, Findings&);
void checkGgx(VerifyContext&, Findings&);
void checkGltf(VerifyContext&, Findings&);
void checkSpecialFunctions(VerifyContext&, Findings&);
void checkFresnel(VerifyContext&, Findings&);
void checkFacets(VerifyContext&, Findings&);
void checkAlbedo(VerifyContext&, Findings&);
void checkBsdfs(VerifyContext&, Findings&);
void checkTexture(VerifyContext&, Findings&);
void checkMaps(VerifyContext&, Findings&);
void checkEnvironment(VerifyContext&, Findings&);
void checkLights(VerifyContext&, Findings&);
void checkShadingPoint(VerifyContext&, Findings&);
void checkTriangle(VerifyContext&, Findings&);
void checkTraverse(VerifyContext&, Findings&);

}  // namespace vkpt
