// Every field of shaders/shared/layout.h means the same on both sides. shaders/probes/layout.comp reads them on the
// device, by name and in the same order.
#include "layout.h"

#include <array>
#include <bit>
#include <cstring>

#include "gpu/transfer.h"
#include "verify/context.h"
#include "verify/probes.h"
#include "wavefront/kernels.h"

namespace vkpt {
namespace {

using Word = std::array<std::uint32_t, 4>;
constexpr std::size_t kFieldsRoom = 32;
using Fields = std::array<Word, kFieldsRoom>;

constexpr std::array kStructs = {"TriangleRecord", "VertexRecord",
                                 "VertexExtra",    "WideNode",
                                 "InstanceRecord", "MaterialRecord",
                                 "TextureRecord",  "LightRecord",
                                 "SceneHeader",    "RenderParams",
                                 "BsdfRecord",     "AlbedoCell",
                                 "FilterCell",     "absorption of a BsdfRecord"};

/// A struct whose 32-bit words all differ, from each other and from those of other structs. As floats they are normal.
template <class T>
T pattern(std::uint32_t kind) {
    std::array<std::uint32_t, sizeof(T) / 4> words;
    for (std::uint32_t i = 0; i < words.size(); ++i) words[i] = 0x40000000U + (kind << 16U) + i;
    return std::bit_cast<T>(words);
}

/// The fields, each at the start of a word of its own.
template <class... Field>
Fields fieldsOf(const Field&... field) {
    Fields fields{};
    std::size_t next = 0;
    (std::memcpy(&fields[next++], &field, sizeof field), ...);
    return fields;
}

struct Records {
    TriangleRecord triangle = pattern<TriangleRecord>(1);
    VertexRecord vertex = pattern<VertexRecord>(2);
    VertexExtra extra = pattern<VertexExtra>(3);
    WideNode node = pattern<WideNode>(4);
    InstanceRecord instance = pattern<InstanceRecord>(5);
    MaterialRecord material = pattern<MaterialRecord>(6);
    TextureRecord texture = pattern<TextureRecord>(7);
    LightRecord light = pattern<LightRecord>(8);
    SceneHeader header = pattern<SceneHeader>(9);
    RenderParams params = pattern<RenderParams>(10);
    BsdfRecord bsdf = pattern<BsdfRecord>(11);
    AlbedoCell cell = pattern<AlbedoCell>(12);
    FilterCell filter = pattern<FilterCell>(13);
};

std::array<Fields, kStructs.size()> expectedFields(const Records& all) {
    const auto& [t, v, e, n, i, m, x, l, h, p, b, c, f] = all;
    return {
        fieldsOf(t.v0, t.flags, t.v1, t.light, t.v2, t.primitive, t.i0, t.i1, t.i2, t.object),
        fieldsOf(v.normal, v.u0, v.v0, v.tangent),
        fieldsOf(e.u1, e.v1, e.colorRG, e.colorBA),
        fieldsOf(n.origin, n.exponents, n.childBase, n.itemBase, n.meta0, n.meta1, n.loX0, n.loX1, n.loY0, n.loY1,
                 n.loZ0, n.loZ1, n.hiX0, n.hiX1, n.hiY0, n.hiY1, n.hiZ0, n.hiZ1),
        fieldsOf(i.objectFromWorld[0], i.objectFromWorld[1], i.objectFromWorld[2], i.worldFromObject[0],
                 i.worldFromObject[1], i.worldFromObject[2], i.rootNode, i.object),
        fieldsOf(m.baseColor, m.emissive, m.metallic, m.roughness, m.normalScale, m.alphaCutoff, m.flags,
                 m.baseColorTexture, m.metallicRoughnessTexture, m.normalTexture, m.emissiveTexture),
        fieldsOf(x.texels, x.size, x.flags, x.stride, x.rowU, x.rowV),
        fieldsOf(l.a, l.kind, l.b, l.pmf, l.c, l.offset, l.color, l.index),
        fieldsOf(h.nodes, h.triangles, h.vertices, h.vertexExtras, h.instances, h.materials, h.textures, h.texels,
                 h.lights, h.lightCdf, h.lightCount, h.rootNode, h.envTexels, h.envRows, h.envColumns, h.envLight,
                 h.envWidth, h.envHeight, h.envCos, h.envSin, h.samplerTable, h.bsdfs, h.albedoTables, h.filterTable,
                 h.lightGroups, h.objectGroups, h.groupBehind),
        fieldsOf(p.eye, p.projection, p.right, p.width, p.up, p.height, p.forward, p.seed, p.background,
                 p.backgroundMode, p.spp, p.maxDepth, p.rrMode, p.rrDepth, p.rrFixed, p.lensRadius, p.focusDistance,
                 p.clampIndirect, p.integrator, p.strategy, p.hemisphere, p.beta, p.bsdfSamples, p.lightSamples,
                 p.aoDistance, p.pixelFilter, p.filterRadius),
        fieldsOf(b.color, b.alphaX, b.diffuse, b.alphaY, b.eta, b.exponentX, b.k, b.exponentY, b.average, b.weight,
                 b.flags, b.table, b.sigma, b.specular),
        fieldsOf(c.x, c.y, c.z, c.w),
        fieldsOf(f.begin, f.end, f.weight),
        fieldsOf(b.diffuse),
    };
}

/// Appends records 0 (zeros) and 1 of one array; the word at which it starts.
template <class T>
std::uint32_t append(std::vector<Word>& words, const T& record) {
    static_assert(sizeof(T) % sizeof(Word) == 0);
    constexpr std::size_t kSize = sizeof(T) / sizeof(Word);
    const std::size_t start = words.size();
    words.resize(start + 2 * kSize);
    std::memcpy(&words[start + kSize], &record, sizeof record);
    return static_cast<std::uint32_t>(start);
}

/// The arrays, one after the other, and their starts in the header. Word 0 stays free so that all starts differ.
std::vector<Word> layOut(Records& records) {
    std::vector<Word> words(1);
    records.header.triangles = append(words, records.triangle);
    records.header.vertices = append(words, records.vertex);
    records.header.vertexExtras = append(words, records.extra);
    records.header.nodes = append(words, records.node);
    records.header.instances = append(words, records.instance);
    records.header.materials = append(words, records.material);
    records.header.textures = append(words, records.texture);
    records.header.lights = append(words, records.light);
    records.header.bsdfs = append(words, records.bsdf);
    records.header.albedoTables = append(words, records.cell);
    records.header.filterTable = append(words, records.filter);
    return words;
}

}  // namespace

void checkLayout(VerifyContext& context, Findings& findings) {
    Device& device = context.prober().device();
    Records records;
    const std::vector<Word> words = layOut(records);
    const Buffer frame(device, BufferUse::Uniform, sizeof(SceneHeader) + sizeof(RenderParams), "frame");
    std::memcpy(frame.map().data(), &records.header, sizeof(SceneHeader));
    std::memcpy(frame.map().data() + sizeof(SceneHeader), &records.params, sizeof(RenderParams));
    const Buffer scene = makeStorage<Word>(device, words, "scene");
    const TexelView texels(device, scene, VK_FORMAT_R32G32B32A32_UINT, 0, scene.size());
    const auto expected = expectedFields(records);

    std::vector<Word> kinds(kStructs.size());
    for (std::uint32_t i = 0; i < kinds.size(); ++i) kinds[i][0] = i;
    for (const bool fetchTexel : {false, true}) {
        const auto read = context.prober().evaluate<Fields>(
            "layout", kinds,
            {.specialization = specializationOf({.textureTransforms = true}, {}, {.fetchTexel = fetchTexel}),
             .extraKinds = {BindingKind::UniformBuffer, BindingKind::StorageBuffer, BindingKind::StorageTexel},
             .extra = {frame, scene, texels}});
        for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
            const auto scope = findings.inputs([&](std::size_t field) {
                return fmt::format("{}, field {}, by {}", kStructs[kind], field, fetchTexel ? "texel" : "storage");
            });
            for (std::size_t field = 0; field < kFieldsRoom; ++field) {
                findings.at(field);
                findings.holds(kStructs[kind], read[kind][field] == expected[kind][field], "reads back otherwise");
            }
        }
    }
}

}  // namespace vkpt
