#include "reference/lights/environment.h"

namespace vkpt::reference {

TableSample sampleTable(std::span<const float> cdf, float u) {
    const auto found = std::upper_bound(cdf.begin(), cdf.end(), u);
    const auto index = std::min<std::size_t>(static_cast<std::size_t>(found - cdf.begin()), cdf.size() - 1);
    const float before = index == 0 ? 0.0F : cdf[index - 1];
    const float width = cdf[index] - before;
    return {static_cast<std::uint32_t>(index), width > 0 ? (u - before) / width : 0.0F};
}

Environment::Environment(const SceneArrays& scene)
    : scene_(scene),
      width_(scene.envTexels.empty() ? 0 : scene.envWidth),
      height_(scene.envTexels.empty() ? 0 : scene.envHeight),
      cos_(std::cos(scene.envRotation)),
      sin_(std::sin(scene.envRotation)) {}

glm::vec2 Environment::uvOf(const glm::vec3& d) const {
    return environmentUv<float>({cos_ * d.x - sin_ * d.z, d.y, sin_ * d.x + cos_ * d.z});
}

glm::vec3 Environment::radiance(const glm::vec3& direction) const {
    if (!exists()) return glm::vec3(0);
    const glm::vec2 corner = uvOf(direction) * glm::vec2(width_, height_) - 0.5F;
    const glm::vec2 whole = glm::floor(corner), fraction = corner - whole;
    const int w = static_cast<int>(width_), h = static_cast<int>(height_);
    const int x = static_cast<int>(whole.x), y = static_cast<int>(whole.y);
    const auto texel = [&](int i, int j) {
        return glm::vec3(
            cell(static_cast<std::uint32_t>((i + w) % w), static_cast<std::uint32_t>(std::clamp(j, 0, h - 1))));
    };
    const glm::vec3 upper = glm::mix(texel(x, y), texel(x + 1, y), fraction.x);
    const glm::vec3 lower = glm::mix(texel(x, y + 1), texel(x + 1, y + 1), fraction.x);
    return glm::mix(upper, lower, fraction.y);
}

float Environment::pdf(const glm::vec3& direction) const {
    if (!exists()) return 0;
    const glm::vec2 position = uvOf(direction) * glm::vec2(width_, height_);
    return cell(std::min(static_cast<std::uint32_t>(position.x), width_ - 1),
                std::min(static_cast<std::uint32_t>(position.y), height_ - 1))
        .w;
}

Environment::Sample Environment::sample(const Vec2<float>& u) const {
    const TableSample row = sampleTable({scene_.envRows.data(), height_}, u.y);
    const std::size_t pitch = (std::size_t{width_} + 3) / 4 * 4;  // rows are padded to whole words
    const TableSample column = sampleTable({scene_.envColumns.data() + row.index * pitch, width_}, u.x);
    const auto turnsOfEdge = [&](std::uint32_t edge) {
        return static_cast<float>(edge) / (2 * static_cast<float>(height_));
    };
    const float cosTheta =
        glm::mix(cosSinTurns(turnsOfEdge(row.index)).x, cosSinTurns(turnsOfEdge(row.index + 1)).x, row.fraction);
    const float longitude = (static_cast<float>(column.index) + column.fraction) / static_cast<float>(width_);
    const glm::vec3 d = environmentDirection(longitude, cosTheta);
    return {{cos_ * d.x + sin_ * d.z, d.y, cos_ * d.z - sin_ * d.x}, cell(column.index, row.index).w};
}

}  // namespace vkpt::reference
