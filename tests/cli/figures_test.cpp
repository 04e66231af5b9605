// tools/figures: its pages of the syllabus and what it measures, from the program that this build made.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdlib>
#include <regex>

#include "base/json.h"
#include "registry.h"
#include "temporary_folder.h"

namespace vkpt {
namespace {

using testing::HasSubstr;

/// Runs figures_lib by the Python that Debian's packages belong to (python3-matplotlib among them, as tools/test
/// installs it); the exit code.
int runFigures(const std::string& arguments, const std::filesystem::path& log) {
    const std::string command = "VKPT='" VKPT_BINARY "' PYTHONPATH='" VKPT_SOURCE
                                "/tools' PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -m figures_lib " +
                                arguments + " > '" + log.string() + "' 2>&1";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// What stands outside pictures, and their number.
struct Page {
    std::string text;
    std::size_t pictures = 0;
};

Page readPage(const std::filesystem::path& file) {
    Page page{.text = readText(file)};
    const std::string begin = "src=\"data:image/png;base64,iVBORw0KGgo";  // the signature of PNG files
    for (std::size_t at = page.text.find(begin); at != std::string::npos; at = page.text.find(begin, at)) {
        const std::size_t end = page.text.find('"', at + begin.size());
        EXPECT_GT(end - at, 4000U) << "picture " << page.pictures << " is next to empty";
        page.text.erase(at, end - at);
        ++page.pictures;
    }
    return page;
}

/// The quick page of one part, of which any must be sound.
Page makePage(const std::string& part) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "page.html";
    if (runFigures("--quick --part " + part + " -o '" + file.string() + "'", folder / "log") != 0) {
        ADD_FAILURE() << readText(folder / "log");
        return {};
    }
    const Page page = readPage(file);
    EXPECT_FALSE(std::regex_search(page.text, std::regex(R"((>|\s)-?(nan|inf)\b)")));
    EXPECT_EQ(page.text.find("http"), std::string::npos) << "a page that needs no other file";
    return page;
}

TEST(Figures, QuickPageShowsTheSyllabusOnSampling) {
    const Page page = makePage("sampling");
    EXPECT_GE(page.pictures, 13U);
    for (const char* shown :
         {"Random against jittered", "shuffle columns", "The curse of dimensionality", "0.25 - 0.09 = 0.16",
          "0.101 = 5/8", "base 97", "hammersley, 512", "(29, 30), faure", "product8", "Spectra of points",
          "relMSE, cornell_box", "relMSE, mis_plates", "bluenoise, 1 spp"})
        EXPECT_THAT(page.text, HasSubstr(shown));
}

TEST(Figures, FullQuickPageShowsTheSyllabusOnLightTransport) {
    const Page page = makePage("transport");
    EXPECT_GE(page.pictures, 10U);
    for (const char* shown :
         {"MIS, balance heuristic", "blue: light sampling errs less", "cosine, 16 spp", "path: 6", "all added",
          "all light: both added: counted twice", "uniform, 256; from above", "sky_with_sun: irradiance from above",
          "importance, 8 spp", "closed room, --rr off, --max-depth 16", "dark walls, 0.2: fixed:0.5"})
        EXPECT_THAT(page.text, HasSubstr(shown));
}

TEST(Figures, FullQuickPageShowsTheSyllabusOnBsdfs) {
    const Page page = makePage("bsdfs");
    EXPECT_GE(page.pictures, 12U);
    for (const char* shown : {"copper; iron; gold; mercury; glass; diamond", "Phong, e = 7.5", "copper, 1981",
                              "GGX\n0.05, 0.4", "EON, r = 1", "from 14 m", "D, logarithmic", "G of a mirrored pair",
                              "<td>3.33", "glass, GGX", "metal, α = 0.6"})
        EXPECT_THAT(page.text, HasSubstr(shown));
}

TEST(Figures, FullMeasureRanksEverySampler) {
    const TemporaryFolder folder;
    ASSERT_EQ(runFigures("--quick --measure -o '" + (folder / "ranks.json").string() + "'", folder / "log"), 0)
        << readText(folder / "log");
    const Json ranks = Json::parse(readText(folder / "ranks.json"));
    for (const char* scene : {"cornell_box", "mis_plates"}) {
        const Json& errors = ranks.at("errors").at(scene);
        ASSERT_EQ(errors.size(), kSamplers.size());
        for (std::size_t i = 0; i < kSamplers.size(); ++i) {
            EXPECT_EQ(errors[i].at("sampler"), kSamplers[i].name);
            EXPECT_GT(errors[i].at("relMSE"), 0.0);
            EXPECT_LT(errors[i].at("trimmedOverRandom"), 1.1) << scene << ' ' << kSamplers[i].name;
        }
    }
    for (const SamplerInfo& sampler : kSamplers)
        EXPECT_GT(ranks.at("cost").at("64").at(std::string(sampler.name)).at("cpuSecondsAMillionPaths"), 0.0);
}

TEST(Figures, FullMeasureTellsTheEfficiencyOfPathTracing) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "transport.json";
    ASSERT_EQ(runFigures("--quick --measure --part transport -o '" + file.string() + "'", folder / "log"), 0)
        << readText(folder / "log");
    for (const Json& row : Json::parse(readText(file)).at("scenes").at("cornell_box")) {
        EXPECT_GT(row.at("trimmed"), 0.0);
        EXPECT_LT(row.at("trimmed"), row.at("relMSE"));
        EXPECT_LT(row.at("relMSE"), 1.0) << "4 samples or more";
        EXPECT_DOUBLE_EQ(row.at("relMSESeconds"), row.at("relMSE").get<double>() * row.at("seconds").get<double>());
    }
    EXPECT_THAT(readText(folder / "log"), HasSubstr("| cornell_box, 4 spp |"));
}

}  // namespace
}  // namespace vkpt
