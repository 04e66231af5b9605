// Inversion of tabulated distributions: integers and comparisons only, hence equality.
#include "reference/lights/environment.h"
#include "scene/sampling_table.h"
#include "verify/context.h"
#include "verify/inputs/random_inputs.h"
#include "verify/probes.h"
#include "wavefront/kernels.h"

namespace vkpt {
namespace {

struct In {
    std::uint32_t base, count;
    float u;
    std::uint32_t steps;
};
struct Out {
    std::uint32_t index;
    float before, at;
    std::uint32_t unused;
};

struct Table {
    std::vector<float> cdf;
    std::uint32_t word;
};

/// Tables of 1 to 1,000 entries, with zero weights at the ends and in runs. All lie in the light table's section, each
/// from a word of its own, followed by garbage where its last word is not full.
std::vector<Table> makeTables(SceneArrays& arrays) {
    std::vector<Table> tables;
    RandomInputs random(20);
    for (const std::size_t count : {1, 2, 3, 4, 5, 7, 8, 9, 16, 17, 31, 64, 65, 255, 1000})
        for (const bool gaps : {false, true}) {
            std::vector<double> weights(count);
            for (double& w : weights) w = gaps && random.unit() < 0.6F ? 0.0 : double{random.unit()};
            Table table{inclusiveCdf(weights), static_cast<std::uint32_t>(arrays.lightCdf.size() / 4)};
            arrays.lightCdf.insert(arrays.lightCdf.end(), table.cdf.begin(), table.cdf.end());
            while (arrays.lightCdf.size() % 4 != 0) arrays.lightCdf.push_back(random.between(-2, 2));
            tables.push_back(table);
        }
    return tables;
}

/// u takes every entry of the tables, its neighbours and the ends.
void compareTables(Prober& prober, Findings& findings) {
    SceneArrays arrays;
    const std::vector<Table> tables = makeTables(arrays);
    const ProbeScene scene(prober, arrays);
    std::vector<In> inputs;
    std::vector<const Table*> tableOf;
    RandomInputs random(21);
    const auto add = [&](const Table& table, float u) {
        if (!(u >= 0 && u < 1)) return;
        const auto count = static_cast<std::uint32_t>(table.cdf.size());
        inputs.push_back({scene.header().lightCdf + table.word, count, u, searchSteps(count)});
        inputs.push_back({scene.header().lightCdf + table.word, count, u, 32});
        tableOf.push_back(&table);
        tableOf.push_back(&table);
    };
    for (const Table& table : tables) {
        add(table, 0);
        add(table, 0x1.fffffep-1F);
        for (const float c : table.cdf)
            for (const float step : {-0x1p-24F, 0.0F, 0x1p-24F}) add(table, c + step);
        for (int i = 0; i < 20; ++i) add(table, random.unit());
    }
    const auto scope = findings.inputs(
        [&](std::size_t i) { return fmt::format("searchCdf: u {} in a table of {}", inputs[i].u, inputs[i].count); });
    const auto out = scene.evaluate<Out>(findings, "cdf", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        const std::vector<float>& cdf = tableOf[i]->cdf;
        const std::uint32_t expected = reference::sampleTable(cdf, inputs[i].u).index;
        findings.equal("index", out[i].index, expected);
        findings.equal("its entry", out[i].at, cdf[expected]);
        findings.equal("the entry before", out[i].before, expected == 0 ? 0 : cdf[expected - 1]);
        findings.holds("interval", out[i].before <= inputs[i].u && inputs[i].u < out[i].at, "does not hold u");
    }
}

/// No table ends below 1, but rounding elsewhere must never lead beyond its end.
void compareEnds(Prober& prober, Findings& findings) {
    SceneArrays arrays;
    std::vector<In> inputs;
    for (const std::uint32_t count : {1U, 3U, 4U, 5U, 30U}) {
        const auto start = static_cast<std::uint32_t>(arrays.lightCdf.size() / 4);
        for (std::uint32_t i = 0; i < count; ++i)
            arrays.lightCdf.push_back(0.5F * static_cast<float>(i + 1) / static_cast<float>(count));
        while (arrays.lightCdf.size() % 4 != 0) arrays.lightCdf.push_back(1);
        inputs.push_back({start, count, 0.75F, 32});
    }
    const ProbeScene scene(prober, arrays);
    for (In& in : inputs) in.base += scene.header().lightCdf;
    const auto scope = findings.inputs(
        [&](std::size_t i) { return fmt::format("searchCdf: u beyond the last of {} entries", inputs[i].count); });
    const auto out = scene.evaluate<Out>(findings, "cdf", inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        findings.at(i);
        findings.equal("index beyond the end", out[i].index, inputs[i].count - 1);
    }
}

}  // namespace

void checkCdf(VerifyContext& context, Findings& findings) {
    compareTables(context.prober(), findings);
    compareEnds(context.prober(), findings);
}

}  // namespace vkpt
