// The checks of rungs 5 and 6.
#pragma once

namespace vkpt {

class VerifyContext;
class Findings;

void checkSameSeed(VerifyContext&, Findings&);
void checkOtherSeeds(VerifyContext&, Findings&);

}  // namespace vkpt
