#include "formats/json_reader.h"

#include <array>
#include <charconv>
#include <cmath>

#include "formats/did_you_mean.h"
#include "formats/json_text.h"

namespace raytree {
namespace {

std::string shortened(std::string text) {
    constexpr std::size_t longest = 60;
    if (text.size() > longest) {
        std::size_t end = longest;
        while ((static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
            --end;  // not within a character
        }
        text.resize(end);
        text += "...";
    }
    return text;
}

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string listed(const ObjectReader::Words& words) {
    std::string text;
    for (std::size_t k = 0; k < words.size(); ++k) {
        text += k == 0 ? "" : k + 1 == words.size() ? " or " : ", ";
        text += json_string(words[k]);
    }
    return text;
}

std::string found_but(const Json& found, std::string_view allowed) {
    return "found " + shown(found) + ", must be " + std::string(allowed);
}

struct Version {
    int major = 0;
    int minor = 0;
};

/// The "1.0" of "raytree-scene/1.0"; none where `format` is not spelt so.
std::optional<Version> version_of(std::string_view format, std::string_view name) {
    if (!format.starts_with(name) || format.substr(name.size()).substr(0, 1) != "/") {
        return std::nullopt;
    }
    format.remove_prefix(name.size() + 1);
    const char* const end = format.data() + format.size();
    Version version;
    const auto major = std::from_chars(format.data(), end, version.major);
    if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.') {
        return std::nullopt;
    }
    const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
    if (minor.ec != std::errc() || minor.ptr != end || version.major < 0 || version.minor < 0) {
        return std::nullopt;
    }
    return version;
}

}  // namespace

void JsonReport::add(const JsonPlace& place, std::string text) {
    if (!is_full()) {
        mistakes.push_back({file, place.pointer(), std::move(text)});
    } else if (mistakes.size() == kMostMistakes) {
        mistakes.push_back({file, "", "further mistakes are left out"});
    }
}

void JsonReport::unknown_key(const JsonPlace& place, std::string text) {
    if (unknown_keys_are_fine) {
        warnings.push_back(Mistake{file, place.pointer(), text + "; it is left out"}.message());
    } else {
        add(place, std::move(text));
    }
}

std::string shown(const Json& value) {
    if (value.is_array()) {
        return "a list of " + std::to_string(value.size());
    }
    if (value.is_object()) {
        return "an object";
    }
    if (value.is_number_float()) {
        return json_number(value.get<double>());
    }
    return shortened(value.dump());
}

void check_json_format(const Json& document, std::string_view name, int major, int minor,
                       JsonReport& report) {
    const std::string own =
        std::string(name) + "/" + std::to_string(major) + "." + std::to_string(minor);
    const JsonPlace top;
    if (!document.is_object()) {
        throw InputError(report.file, "",
                         found_but(document, "an object with \"format\": \"" + own + "\""));
    }
    const auto found = document.find("format");
    if (found == document.end()) {
        throw InputError(report.file, "/format", "is missing, must be \"" + own + "\"");
    }
    const auto version =
        found->is_string() ? version_of(found->get_ref<const std::string&>(), name) : std::nullopt;
    if (!version || version->major != major) {
        throw InputError(report.file, "/format", found_but(*found, "\"" + own + "\""));
    }
    if (version->minor > minor) {
        report.unknown_keys_are_fine = true;
        const std::string text = "is " + shown(*found) + ", newer than the " + own +
                                 " that this program knows; what is new in it is left out";
        report.warnings.push_back(Mistake{report.file, "/format", text}.message());
    }
}

bool ObjectReader::has(std::string_view key) const {
    const Json* const value = find(key);
    return value != nullptr && !value->is_null();
}

bool ObjectReader::is_object(const Json& value, const JsonPlace& place, JsonReport& report) {
    if (!value.is_object()) {
        report.add(place, found_but(value, "an object"));
    }
    return value.is_object();
}

const Json* ObjectReader::find(std::string_view key) const {
    const auto& members = object_.get_ref<const Json::object_t&>();
    for (const auto& [name, value] : members) {
        if (name == key) {
            return &value;
        }
    }
    return nullptr;
}

const Json* ObjectReader::need(std::string_view key, std::string_view allowed) const {
    const Json* const value = find(key);
    if (value == nullptr) {
        report_.add(place_of(key), "is missing, must be " + std::string(allowed));
    }
    return value;
}

const Json* ObjectReader::member(std::string_view key, Need needed,
                                 std::string_view allowed) const {
    return needed == Need::required ? need(key, allowed) : find(key);
}

bool ObjectReader::wrong(std::string_view key, const Json& found, std::string_view allowed) const {
    report_.add(place_of(key), found_but(found, allowed));
    return false;
}

bool ObjectReader::text(std::string_view key, std::string& out, Need needed) const {
    const Json* const value = member(key, needed, "a string");
    if (value == nullptr) {
        return false;
    }
    if (!value->is_string()) {
        return wrong(key, *value, "a string");
    }
    out = value->get<std::string>();
    return true;
}

bool ObjectReader::truth(std::string_view key, bool& out, Need needed) const {
    const Json* const value = member(key, needed, "true or false");
    if (value == nullptr) {
        return false;
    }
    if (!value->is_boolean()) {
        return wrong(key, *value, "true or false");
    }
    out = value->get<bool>();
    return true;
}

bool ObjectReader::number(std::string_view key, double& out, Need needed) const {
    const Json* const value = member(key, needed, "a number");
    if (value == nullptr) {
        return false;
    }
    if (!value->is_number()) {
        return wrong(key, *value, "a number");
    }
    out = value->get<double>();
    return true;
}

bool ObjectReader::whole_number(std::string_view key, std::int64_t& out, Need needed,
                                std::int64_t least, std::int64_t most) const {
    const std::string allowed =
        "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    const Json* const value = member(key, needed, allowed);
    if (value == nullptr) {
        return false;
    }
    // A double holds every whole number up to 2^53, and beyond it is out of range anyhow.
    const double number = value->is_number() ? value->get<double>() : 0.5;
    if (std::floor(number) != number || number < static_cast<double>(least) ||
        number > static_cast<double>(most)) {
        return wrong(key, *value, allowed);
    }
    out = static_cast<std::int64_t>(number);
    return true;
}

bool ObjectReader::point(std::string_view key, Vec3<double>& out, Need needed) const {
    std::array<double, 3> xyz;
    const bool read = numbers(key, xyz.size(), xyz.data(), needed);
    if (read) {
        out = {xyz[0], xyz[1], xyz[2]};
    }
    return read;
}

bool ObjectReader::colour(std::string_view key, Rgb<double>& out, Need needed) const {
    constexpr std::string_view allowed = "an RGB list of 3 numbers, or one number";
    const Json* const value = member(key, needed, allowed);
    if (value == nullptr) {
        return false;
    }
    if (value->is_number()) {
        out = Rgb<double>(value->get<double>());
        return true;
    }
    if (!value->is_array() || value->size() != 3) {
        return wrong(key, *value, allowed);
    }
    std::array<double, 3> rgb;
    const bool read = read_numbers(*value, place_of(key), rgb.size(), rgb.data(), report_);
    if (read) {
        out = {rgb[0], rgb[1], rgb[2]};
    }
    return read;
}

bool ObjectReader::numbers(std::string_view key, std::size_t count, double* out,
                           Need needed) const {
    const Json* const value = member(key, needed, "a list of " + counted(count, "number"));
    return value != nullptr && read_numbers(*value, place_of(key), count, out, report_);
}

bool ObjectReader::points(std::string_view key, std::vector<Vec3<double>>& out, Need needed) const {
    constexpr std::string_view allowed = "a list of points, each a list of 3 numbers";
    const Json* const value = member(key, needed, allowed);
    if (value == nullptr) {
        return false;
    }
    if (!value->is_array()) {
        return wrong(key, *value, allowed);
    }
    bool all = true;
    const JsonPlace list = place_of(key);
    std::vector<Vec3<double>> points;
    points.reserve(value->size());
    for (const Json& element : *value) {
        std::array<double, 3> xyz{};
        all &= read_numbers(element, list.element(points.size()), xyz.size(), xyz.data(), report_);
        points.push_back({xyz[0], xyz[1], xyz[2]});
    }
    if (all) {
        out = std::move(points);
    }
    return all;
}

bool ObjectReader::choice(std::string_view key, const Words& words, std::size_t& out,
                          Need needed) const {
    const Json* const value = member(key, needed, listed(words));
    if (value == nullptr) {
        return false;
    }
    const std::string word = value->is_string() ? value->get<std::string>() : "";
    for (std::size_t k = 0; k < words.size(); ++k) {
        if (word == words[k]) {
            out = k;
            return true;
        }
    }
    return wrong(key, *value, listed(words) + did_you_mean(word, words));
}

void ObjectReader::nothing_but(const Words& known) const {
    for (const auto& [name, value] : object_.get_ref<const Json::object_t&>()) {
        bool is_known = false;
        for (const std::string_view key : known) {
            is_known |= name == key;
        }
        if (!is_known) {
            report_.unknown_key(
                place_of(name),
                "is an unknown key" + did_you_mean(name, known) +
                    (probably_meant(name, known).empty() ? ", must be " + listed(known) : ""));
        }
    }
}

bool read_numbers(const Json& value, const JsonPlace& place, std::size_t count, double* out,
                  JsonReport& report) {
    if (!value.is_array() || value.size() != count) {
        report.add(place, found_but(value, "a list of " + counted(count, "number")));
        return false;
    }
    bool all = true;
    for (std::size_t k = 0; k < count; ++k) {
        if (value[k].is_number()) {
            out[k] = value[k].get<double>();
        } else {
            report.add(place.element(k), found_but(value[k], "a number"));
            all = false;
        }
    }
    return all;
}

}  // namespace raytree
