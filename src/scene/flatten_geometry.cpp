#include "scene/flatten_geometry.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <limits>

#include "base/math.h"
#include "scene/placements.h"

namespace vkpt {
namespace {

constexpr std::size_t kGrain = 8192;              // vertices or triangles a task
constexpr std::uint32_t kNoNormal = 0x80008000U;  // no packed normal has these bits

struct Box {
    glm::vec3 low{std::numeric_limits<float>::infinity()}, high{-std::numeric_limits<float>::infinity()};

    void add(const glm::vec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
    void add(const Box& b) { low = glm::min(low, b.low), high = glm::max(high, b.high); }
    [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
};

/// A run of triangles of one job: written by one task, after the triangles of all runs before it.
struct Run {
    std::uint32_t job = 0;
    std::size_t begin = 0, end = 0;
    std::uint32_t first = 0, kept = 0;
    Box box{};
};

/// One job's matrix, in the forms vertices need.
struct Transform {
    explicit Transform(const glm::mat4& m)
        : linear(m), translation(m[3]), mirrored(glm::determinant(glm::dmat3(linear)) < 0) {
        // The cofactors are the inverse transpose times the determinant, and exist for flattened shapes too.
        const glm::dmat3 d(linear);
        const double sign = mirrored ? -1 : 1;
        cofactors =
            glm::dmat3(glm::cross(d[1], d[2]) * sign, glm::cross(d[2], d[0]) * sign, glm::cross(d[0], d[1]) * sign);
    }
    [[nodiscard]] glm::vec3 point(const glm::vec3& p) const { return linear * p + translation; }
    /// Unit, or zero where it cannot be normalised. Double: cofactors of tiny scales leave float's range.
    [[nodiscard]] glm::vec3 normal(const glm::vec3& n) const { return unit(cofactors * glm::dvec3(n)); }
    [[nodiscard]] glm::vec4 tangent(const glm::vec4& t) const {
        return {unit(glm::dmat3(linear) * glm::dvec3(t)), (t.w < 0) == mirrored ? 1.0F : -1.0F};
    }
    static glm::vec3 unit(const glm::dvec3& v) {
        const double length = glm::length(v);
        return length > 0 && length < std::numeric_limits<double>::infinity() ? glm::vec3(v / length) : glm::vec3(0);
    }

    glm::mat3 linear;
    glm::vec3 translation;
    bool mirrored;
    glm::dmat3 cofactors;
};

/// Float arithmetic can give the triangle a unit normal, as both renderers do.
bool hasArea(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 n = glm::cross(b - a, c - a);
    const float square = glm::dot(n, n);
    return square >= std::numeric_limits<float>::min() && square <= std::numeric_limits<float>::max();
}

std::uint32_t packUnorm16(float low, float high) {
    const auto quantise = [](float v) {
        return static_cast<std::uint32_t>(std::lrint(std::clamp(v, 0.0F, 1.0F) * 65535.0F));
    };
    return quantise(low) | quantise(high) << 16U;
}

float finiteOrZero(float v) { return std::isfinite(v) ? v : 0.0F; }

class Writer {
public:
    Writer(const GeometryPlan& plan, const std::vector<MaterialTraits>& traits, SceneArrays& arrays)
        : plan_(plan), traits_(traits), arrays_(arrays), positions_(plan.vertices) {
        transforms_.reserve(plan.jobs.size());
        for (const GeometryJob& job : plan.jobs) transforms_.emplace_back(job.matrix);
    }

    void write() {
        writeVertices();
        makeRuns();
        writeTriangles();
        placeShared();
    }

private:
    void writeVertices();
    void writeVertex(const GeometryJob& job, const Transform& transform, std::size_t i);
    void makeRuns();
    void writeTriangles();
    void writeRun(Run& run);
    void fillNormals();
    void placeShared();
    [[nodiscard]] glm::uvec3 corners(const Run& run, std::size_t triangle) const;
    [[nodiscard]] std::uint32_t triangleFlags(const Primitive& primitive, const glm::uvec3& t) const;

    const GeometryPlan& plan_;
    const std::vector<MaterialTraits>& traits_;
    SceneArrays& arrays_;
    std::vector<glm::vec3> positions_;  // after the job's matrix
    std::vector<Transform> transforms_;
    std::vector<Run> runs_;
    std::vector<Box> rangeBoxes_;
    std::atomic<bool> missingNormals_ = false;
};

void Writer::writeVertices() {
    arrays_.vertices.resize(plan_.vertices);
    for (const GeometryJob& job : plan_.jobs) {
        arrays_.features.vertexExtras |= !job.primitive->uv1.empty() || !job.primitive->colors.empty();
    }
    if (arrays_.features.vertexExtras) arrays_.vertexExtras.resize(plan_.vertices);

    tbb::parallel_for(std::size_t{0}, plan_.jobs.size(), [&](std::size_t j) {
        const GeometryJob& job = plan_.jobs[j];
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, job.primitive->positions.size(), kGrain),
                          [&](const tbb::blocked_range<std::size_t>& part) {
                              for (std::size_t i = part.begin(); i != part.end(); ++i) {
                                  writeVertex(job, transforms_[j], i);
                              }
                          });
    });
}

void Writer::writeVertex(const GeometryJob& job, const Transform& transform, std::size_t i) {
    const Primitive& primitive = *job.primitive;
    const std::size_t slot = job.firstVertex + i;
    positions_[slot] = transform.point(primitive.positions[i]);
    VertexRecord& vertex = arrays_.vertices[slot];
    const glm::vec3 normal = primitive.normals.empty() ? glm::vec3(0) : transform.normal(primitive.normals[i]);
    vertex.normal = normal == glm::vec3(0) ? kNoNormal : packNormal(normal);
    if (normal == glm::vec3(0)) missingNormals_.store(true, std::memory_order_relaxed);
    if (!primitive.tangents.empty()) vertex.tangent = packTangent(transform.tangent(primitive.tangents[i]));
    if (!primitive.uv0.empty()) {
        vertex.u0 = finiteOrZero(primitive.uv0[i].x);
        vertex.v0 = finiteOrZero(primitive.uv0[i].y);
    }
    if (!arrays_.features.vertexExtras) return;
    const glm::vec2 uv1 = primitive.uv1.empty() ? glm::vec2(0) : primitive.uv1[i];
    const glm::vec4 color = primitive.colors.empty() ? glm::vec4(1) : primitive.colors[i];
    arrays_.vertexExtras[slot] = {finiteOrZero(uv1.x), finiteOrZero(uv1.y), packUnorm16(color.r, color.g),
                                  packUnorm16(color.b, color.a)};
}

/// Vertex indices of a triangle, counter-clockwise from the front after the job's matrix.
glm::uvec3 Writer::corners(const Run& run, std::size_t triangle) const {
    const GeometryJob& job = plan_.jobs[run.job];
    glm::uvec3 t = job.primitive->triangles[triangle];
    if (transforms_[run.job].mirrored) std::swap(t.y, t.z);
    return t + glm::uvec3(job.firstVertex);
}

/// Cuts the jobs into runs, drops triangles without area and lays out what remains.
void Writer::makeRuns() {
    for (std::uint32_t j = 0; j < plan_.jobs.size(); ++j) {
        const std::size_t count = plan_.jobs[j].primitive->triangles.size();
        for (std::size_t begin = 0; begin < count; begin += kGrain) {
            runs_.push_back({.job = j, .begin = begin, .end = std::min(begin + kGrain, count)});
        }
    }
    tbb::parallel_for(std::size_t{0}, runs_.size(), [&](std::size_t r) {
        Run& run = runs_[r];
        for (std::size_t i = run.begin; i < run.end; ++i) {
            const glm::uvec3 t = corners(run, i);
            run.kept += hasArea(positions_[t.x], positions_[t.y], positions_[t.z]) ? 1 : 0;
        }
    });

    arrays_.meshRanges.assign(plan_.ranges, {});
    std::uint32_t next = 0;
    for (Run& run : runs_) {
        MeshRange& range = arrays_.meshRanges[plan_.jobs[run.job].range];
        if (range.triangleCount == 0) range.firstTriangle = next;
        run.first = next;
        range.triangleCount += run.kept;
        next += run.kept;
        arrays_.droppedTriangles += run.end - run.begin - run.kept;
    }
    arrays_.triangles.resize(next);
}

void Writer::writeTriangles() {
    tbb::parallel_for(std::size_t{0}, runs_.size(), [&](std::size_t r) { writeRun(runs_[r]); });
    rangeBoxes_.assign(plan_.ranges, {});
    for (const Run& run : runs_) rangeBoxes_[plan_.jobs[run.job].range].add(run.box);
    for (const TriangleRecord& triangle : arrays_.triangles) {
        arrays_.features.alpha |= (triangle.flags & kTriangleHasAlpha) != 0;
    }
    if (missingNormals_) fillNormals();
}

/// A vertex without a usable normal gets that of the first triangle at it.
void Writer::fillNormals() {
    for (const TriangleRecord& triangle : arrays_.triangles) {
        const glm::dvec3 a(triangle.v0), b(triangle.v1), c(triangle.v2);
        for (const std::uint32_t i : {triangle.i0, triangle.i1, triangle.i2}) {
            std::uint32_t& normal = arrays_.vertices[i].normal;
            if (normal == kNoNormal) normal = packNormal(Transform::unit(glm::cross(b - a, c - a)));
        }
    }
    for (VertexRecord& vertex : arrays_.vertices) {
        if (vertex.normal == kNoNormal) vertex.normal = 0;  // of no triangle that was kept
    }
}

void Writer::writeRun(Run& run) {
    const GeometryJob& job = plan_.jobs[run.job];
    std::uint32_t slot = run.first;
    for (std::size_t i = run.begin; i < run.end; ++i) {
        const glm::uvec3 t = corners(run, i);
        if (!hasArea(positions_[t.x], positions_[t.y], positions_[t.z])) continue;
        TriangleRecord& triangle = arrays_.triangles[slot];
        triangle.v0 = positions_[t.x];
        triangle.v1 = positions_[t.y];
        triangle.v2 = positions_[t.z];
        triangle.flags = triangleFlags(*job.primitive, job.primitive->triangles[i]);
        triangle.light = kNone;
        triangle.primitive = slot;
        triangle.i0 = t.x, triangle.i1 = t.y, triangle.i2 = t.z;
        triangle.object = job.object;
        for (const glm::vec3& p : {triangle.v0, triangle.v1, triangle.v2}) run.box.add(p);
        ++slot;
    }
}

std::uint32_t Writer::triangleFlags(const Primitive& primitive, const glm::uvec3& t) const {
    const MaterialRecord& material = arrays_.materials[primitive.material];
    std::uint32_t flags = primitive.material << kTriangleMaterialShift;
    const std::uint32_t model = material.flags >> kMaterialModelShift & kMaterialModelMask;
    flags |= static_cast<std::uint32_t>(kBsdfModels[model].group) << kTriangleGroupShift;
    const bool seenThrough = model == static_cast<std::uint32_t>(BsdfId::Dielectric);  // from inside too
    if ((material.flags & kMaterialDoubleSided) == 0 && !seenThrough) flags |= kTriangleSingleSided;
    const bool mask = (material.flags & kMaterialAlphaMask) != 0;
    if (mask || (material.flags & kMaterialAlphaBlend) != 0) {
        float alpha = material.baseColor.a * traits_[primitive.material].minTextureAlpha;
        if (!primitive.colors.empty()) {
            alpha *= std::min({primitive.colors[t.x].a, primitive.colors[t.y].a, primitive.colors[t.z].a});
        }
        // Opaque wherever it is read: neither side need ask.
        if (!(alpha >= (mask ? material.alphaCutoff : 1.0F))) flags |= kTriangleHasAlpha;
    }
    return flags;
}

InstanceRecord instanceRecord(const glm::mat4& worldFromObject, std::uint32_t object) {
    const glm::mat4 rows = glm::transpose(worldFromObject);
    const glm::mat4 inverse(glm::transpose(glm::inverse(glm::dmat4(worldFromObject))));
    InstanceRecord record{};
    for (int i = 0; i < 3; ++i) {
        record.worldFromObject[i] = rows[i];
        record.objectFromWorld[i] = inverse[i];
    }
    record.object = object;
    return record;
}

void Writer::placeShared() {
    Box bounds = rangeBoxes_[0];
    if (!plan_.shared.empty()) {
        if (arrays_.meshRanges[0].triangleCount != 0) {
            arrays_.instances.push_back(instanceRecord(glm::mat4(1), kNone));
            arrays_.instanceMesh.push_back(0);
        }
        for (const SharedPlacement& place : plan_.shared) {
            const Box& box = rangeBoxes_[place.range];
            if (box.empty()) continue;
            arrays_.instances.push_back(instanceRecord(place.matrix, place.object));
            arrays_.instanceMesh.push_back(place.range);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 p = glm::mix(box.low, box.high, glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2));
                bounds.add(glm::vec3(place.matrix * glm::vec4(p, 1)));
            }
        }
    }
    arrays_.features.instances = !arrays_.instances.empty();
    if (!arrays_.features.instances) arrays_.meshRanges.resize(1);
    if (!bounds.empty()) arrays_.boundsMin = bounds.low, arrays_.boundsMax = bounds.high;
}

}  // namespace

void flattenGeometry(const Scene& scene, const FlattenOptions& options, const std::vector<MaterialTraits>& traits,
                     SceneArrays& arrays) {
    const GeometryPlan plan = planGeometry(scene, options, traits);
    arrays.droppedInstances = plan.droppedInstances;
    Writer(plan, traits, arrays).write();
    for (const MeshInstance& instance : scene.instances) arrays.objectNames.push_back(instance.name);
}

}  // namespace vkpt
