#include "gltf/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/error.h"
#include "gltf/schema_tables.h"

namespace vkpt::gltf {
namespace {

using Json = nlohmann::json;

// glTF allows integers in floating-point form (5126.0). [glTF 2.0, §2.7]
bool isSize(const Json& value, std::size_t least, std::size_t most) {
    if (!value.is_number()) return false;
    const auto number = value.get<double>();
    return number >= static_cast<double>(least) && number <= static_cast<double>(most) && number == std::floor(number);
}

bool isFiniteFloat(const Json& value) {
    return value.is_number() && std::isfinite(static_cast<float>(value.get<double>()));
}

class Checker {
public:
    Checker(Json& root, const std::string& file) : root_(root), file_(file) {}

    void object(Json& value, std::span<const Field> fields) {
        if (!value.is_object()) fail("must be an object");
        for (auto item = value.begin(); item != value.end();) {
            const auto known = [&](const Field& field) { return field.name == item.key(); };
            item = std::any_of(fields.begin(), fields.end(), known) ? std::next(item) : value.erase(item);
        }
        for (const Field& field : fields) {
            const std::size_t length = path_.size();
            path_ += path_.empty() ? "" : ".";
            path_ += field.name;
            const auto found = value.find(field.name);
            if (found != value.end())
                member(*found, field);
            else if (field.required)
                fail("is missing");
            path_.resize(length);
        }
    }

private:
    void member(Json& value, const Field& field) {
        switch (field.kind) {
            case Kind::Array:
                return elements(value, [](Json& item) { item = Json::object(); });
            case Kind::AnyObject:
                return require(value.is_object(), "must be an object");
            case Kind::Boolean:
                return require(value.is_boolean(), "must be true or false");
            case Kind::Index:
                return indexInto(value, field.section);
            case Kind::Indices:
                return elements(value, [&](Json& item) { indexInto(item, field.section); });
            case Kind::IndexMap:
                return indexMap(value, field.section);
            case Kind::Number:
                return number(value, field);
            case Kind::Numbers:
                if (!value.is_array() || value.size() != field.length)
                    fail(fmt::format("must be an array of {} numbers", field.length));
                return elements(value, [&](Json& item) { number(item, field); });
            case Kind::Object:
                return object(value, {field.fields, field.length});
            case Kind::Objects:
                elements(value, [&](Json& item) { object(item, {field.fields, field.length}); });
                return require(value.size() >= field.least, "must not be empty");
            case Kind::Size:
                if (!isSize(value, field.least, field.most))
                    fail(field.most == kLargestInteger
                             ? fmt::format("must be an integer from {} up", field.least)
                             : fmt::format("must be an integer from {} to {}", field.least, field.most));
                value = value.get<std::size_t>();
                return;
            case Kind::String:
                return require(value.is_string(), "must be a string");
            case Kind::Strings:
                return elements(value, [&](const Json& item) { require(item.is_string(), "must be a string"); });
        }
    }

    template <typename Visit>
    void elements(Json& value, Visit&& visit) {
        require(value.is_array(), "must be an array");
        std::size_t i = 0;
        const std::size_t length = path_.size();
        for (Json& item : value) {
            fmt::format_to(std::back_inserter(path_), "[{}]", i++);
            visit(item);
            path_.resize(length);
        }
    }

    void indexMap(Json& value, std::string_view section) {
        require(value.is_object(), "must be an object");
        const std::size_t length = path_.size();
        for (auto item = value.begin(); item != value.end(); ++item) {
            path_ += "." + item.key();
            indexInto(*item, section);
            path_.resize(length);
        }
    }

    void number(Json& value, const Field& field) {
        if (!isFiniteFloat(value)) fail("must be a number");
        const auto number = value.get<double>();
        if (!(number >= field.low && number <= field.high)) fail(fmt::format("{} is {}", number, rangeText(field)));
        value = number;
    }

    static std::string rangeText(const Field& field) {
        const std::string low = field.low == kTiny ? "greater than 0" : fmt::format("{} or more", field.low);
        return field.high < kInfinity ? fmt::format("not between {:.4g} and {:.4g}", field.low, field.high)
                                      : "not " + low;
    }

    void indexInto(Json& value, std::string_view section) {
        if (!isSize(value, 0, kLargestInteger)) fail("must be an index");
        const auto found = root_.find(section);
        const std::size_t count = found != root_.end() && found->is_array() ? found->size() : 0;
        if (value.get<std::size_t>() >= count)
            fail(fmt::format("{}, but the file has {} {}", value.get<std::size_t>(), count, section));
        value = value.get<std::size_t>();
    }

    void require(bool holds, std::string_view fault) {
        if (!holds) fail(fault);
    }

    [[noreturn]] void fail(std::string_view fault) {
        throw FileError(file_, path_.empty() ? fmt::format("the file {}", fault) : fmt::format("{}: {}", path_, fault));
    }

    Json& root_;
    const std::string& file_;
    std::string path_;
};

}  // namespace

void checkSchema(nlohmann::json& root, const std::string& file) { Checker(root, file).object(root, kRoot); }

}  // namespace vkpt::gltf
