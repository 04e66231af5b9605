// What users may write for a BSDF, and what they are told where it is wrong.
#include "scene/bsdf_spec.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "base/error.h"
#include "base/json.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

using testing::HasSubstr;

std::string faultOf(std::string_view text) {
    try {
        (void)parseBsdfSpec(text);
    } catch (const std::invalid_argument& fault) {
        return fault.what();
    }
    return "no fault";
}

TEST(BsdfSpec, ABareNameHasDefaults) {
    for (const BsdfModelInfo& info : kBsdfModels) {
        EXPECT_EQ(parseBsdfSpec(info.name), defaultBsdf(info.id)) << info.name;
        EXPECT_THAT(bsdfHelp(), HasSubstr(std::string(info.name)));
    }
}

TEST(BsdfSpec, ThreeWaysOfWritingAreOne) {
    const auto brief = parseBsdfSpec("conductor:metal=Au,alpha=0.1/0.3,distribution=beckmann");
    EXPECT_EQ(brief.alpha, glm::vec2(0.1F, 0.3F));
    EXPECT_EQ(brief.distribution, Distribution::Beckmann);
    EXPECT_TRUE(brief.metal);
    const std::string json =
        R"({"model": "conductor", "metal": "Au", "alpha": [0.1, 0.3], "distribution": "beckmann"})";
    EXPECT_EQ(parseBsdfSpec(json), brief);
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "gold.json") << json;
    EXPECT_EQ(parseBsdfSpec("@" + (folder.path() / "gold.json").string()), brief);
}

TEST(BsdfSpec, JsonOfASpecReadsBack) {
    for (const std::string_view text :
         {"gltf:color=0.1/0.2/0.3,metallic=1,roughness=0.2", "dielectric:ior=diamond,alpha=0.2",
          "blinn_phong:normalization=lecture", "ashikhmin_shirley:exponent=3/700",
          "cook_torrance:preset=copper_plastic", "conductor:masking=smith_separable", "conductor:eta=1/2/3,k=4",
          "torrance_sparrow:ior=1.7", "dielectric:attenuation_color=0.1/1/0.5,attenuation_distance=3",
          "plastic:diffuse=0.2/0.4/0.6", "oren_nayar:sigma=0.3"}) {
        const BsdfSpec spec = parseBsdfSpec(text);
        EXPECT_EQ(bsdfFromJson(bsdfToJson(spec)), spec) << text << " as " << bsdfToJson(spec).dump();
    }
}

TEST(BsdfSpec, FaultsNameFieldAndMend) {
    EXPECT_EQ(faultOf("lambert:color=2"), "color: 2.0 is not within 0 and 1");
    EXPECT_THAT(faultOf("velvet"), HasSubstr("model: \"velvet\" is not one of gltf, lambert"));
    EXPECT_EQ(faultOf("lambert:alpha=0.1"), "alpha: is no key of lambert; its keys are color");
    EXPECT_EQ(faultOf("conductor:metal=Xx"), "metal: \"Xx\" is not one of Cu, Fe, Au, Ag, Al, Hg");
    EXPECT_EQ(faultOf("conductor:metal=Cu,eta=1,k=2"), "metal, ior, and eta with k: give one of the three");
    EXPECT_EQ(faultOf("conductor:eta=1"), "eta, k: a metal needs both");
    EXPECT_EQ(faultOf("dielectric:ior=0.5"), "ior: 0.5 is not within 1.01 and 10");
    EXPECT_EQ(faultOf("conductor:alpha=0.1/0.2/0.3"), "alpha: [0.1,0.2,0.3] is not one number or 2");
    EXPECT_EQ(faultOf("conductor:alpha"), "\"alpha\": expected key=value");
    EXPECT_THAT(faultOf("{\"model\": "), HasSubstr("is no JSON at byte"));
    EXPECT_EQ(faultOf("{\"alpha\": 1}"), "model: is missing");
    EXPECT_EQ(faultOf("dielectric:attenuation_color=0"), "attenuation_color: 0.0 is not within 1e-06 and 1");
    EXPECT_EQ(faultOf("dielectric:attenuation_distance=0"), "attenuation_distance: 0.0 is not within 1e-06 and 1e+06");
    EXPECT_THAT(faultOf("conductor:attenuation_distance=1"), HasSubstr("attenuation_distance: is no key of conductor"));
    EXPECT_EQ(faultOf("lambert:color=nan"), "color: \"nan\" is not within 0 and 1");
    EXPECT_THROW((void)parseBsdfSpec("@/nonexistent/spec.json"), FileError);
}

// After the distance the colour is left: exp(-absorption x distance).
TEST(BsdfRecord, AbsorptionLeavesTheColourAfterTheDistance) {
    const BsdfRecord tinted =
        bsdfRecord(parseBsdfSpec("dielectric:attenuation_color=0.5/0.25/1,attenuation_distance=0.5"));
    EXPECT_NEAR(tinted.diffuse.r, 2 * std::log(2.0), 1e-6);
    EXPECT_NEAR(tinted.diffuse.g, 4 * std::log(2.0), 1e-6);
    EXPECT_EQ(tinted.diffuse.b, 0);
    EXPECT_EQ(bsdfRecord(parseBsdfSpec("dielectric")).diffuse, glm::vec3(0)) << "clear unless told otherwise";
}

TEST(BsdfRecord, MeansOfFresnelAreThePublishedOnes) {
    // Internal diffuse reflectance of ior 1.5 is 0.596; outside 0.092. [Duntley 42; Egan 73]
    const BsdfRecord glass = bsdfRecord(parseBsdfSpec("dielectric:ior=1.5"));
    EXPECT_NEAR(glass.average.x, 0.0918, 5e-4);
    EXPECT_NEAR(glass.average.y, 0.5963, 5e-4);
}

}  // namespace
}  // namespace vkpt
