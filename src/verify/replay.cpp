#include "verify/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "verify/context.h"
#include "verify/stages/path_record.h"

namespace vkpt {
namespace {

/// Where and how a surface is shaded.
struct SurfacePoint {
    glm::vec3 position{0}, normal{0, 0, 1};
};

/// The device's own view of the surfaces its paths met: shaders/probes/shading_point.comp.
class DeviceSurfaces {
public:
    explicit DeviceSurfaces(VerifyContext& context)
        : prober_(context.prober()), scene_(prober_, context.scene(), context.options().params) {}

    SurfacePoint at(const PathStep& step) {
        struct In {
            std::uint32_t slot, instance;
            float b1, b2;
            glm::vec4 wo;
        };
        struct Out {
            glm::vec3 position;
            float offset;
            glm::vec3 ng;
            float front;
            glm::vec3 ns;
            std::uint32_t light;
            glm::vec4 baseColor, uv;
        };
        const reference::Hit& hit = *step.hit;
        const std::vector<In> in = {{hit.triangle, hit.instance == kNone ? 0 : hit.instance, hit.barycentrics.y,
                                     hit.barycentrics.z, glm::vec4(-step.state.ray.direction, 0)}};
        const Out out = prober_.evaluate<Out>("shading_point", in, scene_.options(Fetch::Storage))[0];
        return {out.position, out.ns};
    }

private:
    Prober& prober_;
    ProbeScene scene_;
};

/// Values of one side: numbers, or a word where there are none.
struct Value {
    std::vector<double> numbers;
    std::string word = "-";

    Value() = default;
    Value(std::string text) : word(std::move(text)) {}  // NOLINT(google-explicit-constructor)
    Value(double number) : numbers{number} {}           // NOLINT(google-explicit-constructor)
    template <class T>
    Value(const glm::vec<3, T>& v) : numbers{double(v.x), double(v.y), double(v.z)} {}  // NOLINT

    [[nodiscard]] std::string text() const {
        if (numbers.empty()) return word;
        std::string text;
        for (const double n : numbers) text += fmt::format("{}{:.6g}", text.empty() ? "" : "  ", n);
        return text;
    }
};

bool isSame(const Value& a, const Value& b) {
    if (a.numbers.size() != b.numbers.size()) return false;
    if (a.numbers.empty()) return a.word == b.word;
    double size = 0, error = 0;
    for (std::size_t i = 0; i < a.numbers.size(); ++i) {
        if (a.numbers[i] == b.numbers[i]) continue;  // infinities among them
        size = std::max({size, std::abs(a.numbers[i]), std::abs(b.numbers[i])});
        error = std::fmax(error, std::abs(a.numbers[i] - b.numbers[i]));
    }
    return error <= kReplayRelative * size + 1e-9;
}

std::string nameOf(const std::vector<std::string>& names, std::uint32_t index) {
    return index < names.size() && !names[index].empty() ? fmt::format("{} \"{}\"", index, names[index])
                                                         : fmt::format("{}", index);
}

/// One side of a vertex, by the names of its rows.
using Side = std::vector<std::pair<std::string, Value>>;

void describeHit(Side& side, const SceneArrays& scene, const PathStep& step, const SurfacePoint& point) {
    if (!step.hit) {
        side.emplace_back("meets", std::string("nothing"));
        return;
    }
    const TriangleRecord& triangle = scene.triangles[step.hit->triangle];
    const std::uint32_t object = reference::objectOf(scene, *step.hit);
    side.emplace_back("meets", fmt::format("triangle {} of {}", triangle.primitive, nameOf(scene.objectNames, object)));
    side.emplace_back("distance", double{step.hit->t});
    side.emplace_back("position", point.position);
    side.emplace_back("normal", point.normal);
    side.emplace_back("material", nameOf(scene.materialNames, triangle.flags >> kTriangleMaterialShift));
}

void describeLight(Side& side, const PathStep& step) {
    if (!step.direct) {
        side.emplace_back("light sample", std::string("none"));
        return;
    }
    const reference::DirectLight& light = *step.direct;
    const bool infinite = std::isinf(light.tMax);
    side.emplace_back("light sample", light.shadowRay.direction / glm::length(light.shadowRay.direction));
    side.emplace_back("  at distance",
                      infinite ? Value("infinite") : Value(double{glm::length(light.shadowRay.direction)}));
    side.emplace_back("  arrives", std::string(step.arrives ? "yes" : "no"));
    side.emplace_back("  contribution", step.arrives ? light.contribution : glm::vec3(0));
}

Side describe(const SceneArrays& scene, const PathStep& step, const SurfacePoint& point) {
    Side side;
    side.emplace_back("ray from", step.state.ray.origin);
    side.emplace_back("  towards", step.state.ray.direction);
    describeHit(side, scene, step, point);
    side.emplace_back("emitted", step.emitted);
    if (!step.hit) return side;
    describeLight(side, step);
    if (!step.next) {
        side.emplace_back("bsdf sample", std::string("the path ends"));
        return side;
    }
    const float pdf = step.next->pdfBsdf;
    side.emplace_back("bsdf sample", step.next->ray.direction);
    side.emplace_back("  pdf", std::isinf(pdf) ? Value("mirror") : Value(double{pdf}));
    side.emplace_back("throughput", step.next->throughput);
    return side;
}

/// Rows of both sides next to each other; a name that one side lacks has "-" there.
std::vector<ReplayRow> joinSides(const Side& device, const Side& reference) {
    std::vector<ReplayRow> rows;
    const auto find = [](const Side& side, const std::string& name) {
        const auto found = std::ranges::find(side, name, &Side::value_type::first);
        return found == side.end() ? Value() : found->second;
    };
    const auto add = [&](const std::string& name) {
        if (std::ranges::count(rows, name, &ReplayRow::name) > 0) return;
        const Value a = find(device, name), b = find(reference, name);
        rows.push_back({name, a.text(), b.text(), isSame(a, b)});
    };
    for (const auto& [name, value] : device.size() >= reference.size() ? device : reference) add(name);
    for (const auto& [name, value] : device) add(name);
    for (const auto& [name, value] : reference) add(name);
    return rows;
}

SurfacePoint referencePoint(const reference::PathTracer& tracer, const PathStep& step) {
    if (!step.hit) return {};
    const reference::ShadingPoint point = tracer.shade(step.state, *step.hit).point;
    return {point.position, point.ns};
}

}  // namespace

std::optional<ReplayPath::Parting> ReplayPath::parting() const {
    for (const ReplayVertex& vertex : vertices)
        for (const ReplayRow& row : vertex.rows)
            if (!row.same) return Parting{vertex.bounce, row.name, row.device, row.reference};
    return std::nullopt;
}

std::vector<ReplayPath> replayPixel(VerifyContext& context, std::uint32_t x, std::uint32_t y, std::uint32_t begin,
                                    std::uint32_t end) {
    const DevicePaths paths(context.scene(), context.options());
    context.renderer().select(context.options().params.seed, begin, end);
    const auto device = recordDevice(paths, context.renderer(), y * context.options().params.width + x);
    DeviceSurfaces surfaces(context);
    std::vector<ReplayPath> replayed;
    for (std::uint32_t i = 0; i < device.size(); ++i) {
        ReplayPath path{begin + i, {}};
        const PathRecord reference = recordReference(paths.tracer(), x, y, path.sample);
        const std::size_t vertices = std::min(device[i].size(), reference.size());
        for (std::uint32_t bounce = 0; bounce < vertices && !path.parting(); ++bounce) {
            const PathStep &a = device[i][bounce], &b = reference[bounce];
            const Side left = describe(context.scene(), a, a.hit ? surfaces.at(a) : SurfacePoint{});
            const Side right = describe(context.scene(), b, referencePoint(paths.tracer(), b));
            path.vertices.push_back({bounce, joinSides(left, right)});
        }
        replayed.push_back(std::move(path));
    }
    return replayed;
}

std::string replayText(const std::vector<ReplayPath>& paths) {
    std::string text;
    for (const ReplayPath& path : paths) {
        const auto parting = path.parting();
        text += fmt::format("sample {}: {}\n", path.sample,
                            parting ? fmt::format("the paths part at bounce {}: {}", parting->bounce, parting->row)
                                    : fmt::format("the same on both sides, {} vertices", path.vertices.size()));
        for (const ReplayVertex& vertex : path.vertices) {
            text += fmt::format("  bounce {:<10}{:<38}{}\n", vertex.bounce, "vulkan", "cpu");
            for (const ReplayRow& row : vertex.rows)
                text += fmt::format("  {} {:<15}{:<38}{}\n", row.same ? ' ' : '!', row.name, row.device, row.reference);
        }
    }
    return text;
}

Json replayJson(const std::vector<ReplayPath>& paths) {
    Json list = Json::array();
    for (const ReplayPath& path : paths) {
        Json vertices = Json::array();
        for (const ReplayVertex& vertex : path.vertices) {
            Json rows = Json::array();
            for (const ReplayRow& row : vertex.rows)
                rows.push_back(
                    {{"name", row.name}, {"vulkan", row.device}, {"cpu", row.reference}, {"same", row.same}});
            vertices.push_back({{"bounce", vertex.bounce}, {"rows", rows}});
        }
        const auto parting = path.parting();
        list.push_back({{"sample", path.sample},
                        {"partsAtBounce", parting ? Json(parting->bounce) : Json()},
                        {"vertices", vertices}});
    }
    return list;
}

}  // namespace vkpt
