// Light transport in closed form on the device.
#include "closed_forms.h"

#include "wavefront/render_helpers.h"

namespace vkpt {
namespace {

namespace closed_forms = test::closed_forms;

TEST(DeviceEstimators, FurnaceOfEveryIntegrator) { closed_forms::furnaceOfEveryIntegrator(onDevice); }
TEST(DeviceEstimators, FullFurnaceShowsTheAlbedo) { closed_forms::furnaceShowsTheAlbedo(onDevice); }
TEST(DeviceEstimators, FullDiscLightOverAPlane) { closed_forms::discLightOverAPlane(onDevice); }
TEST(DeviceEstimators, FullSphereInsideASphere) { closed_forms::sphereInsideASphere(onDevice); }
TEST(DeviceEstimators, FullPunctualLightsAreForLightSamplesAlone) {
    closed_forms::punctualLightsAreForLightSamplesAlone(onDevice);
}
TEST(DeviceEstimators, FullSpotFallsOffBetweenItsCones) { closed_forms::spotFallsOffBetweenItsCones(onDevice); }
TEST(DeviceEstimators, FullAMirrorShowsALamp) { closed_forms::aMirrorShowsALamp(onDevice); }
TEST(DeviceEstimators, FullRouletteKeepsTheMean) { closed_forms::rouletteKeepsTheMean(onDevice); }
TEST(DeviceEstimators, FullEnergyOfAThousandBounces) { closed_forms::energyOfAThousandBounces(onDevice); }

}  // namespace
}  // namespace vkpt
