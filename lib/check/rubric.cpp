#include "check/rubric.h"

#include <algorithm>
#include <cmath>

#include "formats/json_reader.h"

namespace raytree::check {
namespace {

constexpr std::array<std::string_view, 4> kind_words = {"primary", "reflected", "refracted",
                                                        "shadow"};

void read_points(const ObjectReader& reader, std::string_view key, double& out,
                 JsonReport& report) {
    if (reader.number(key, out, Need::optional) && !(out >= 0)) {
        report.add(reader.place_of(key), "must be 0 or more");
    }
}

/// The object under `key`, if there is one.
template <class Read>
void within(const ObjectReader& reader, std::string_view key, JsonReport& report, Read read) {
    const Json* const value = reader.find(key);
    const JsonPlace place = reader.place_of(key);
    if (value && ObjectReader::is_object(*value, place, report)) {
        read(ObjectReader(*value, place, report), *value);
    }
}

void read_levels(const ObjectReader& reader, const Json& value, Rubric& rubric,
                 JsonReport& report) {
    for (const auto& [level, factor] : value.get_ref<const Json::object_t&>()) {
        const bool whole = !level.empty() && level.size() <= 4 && level.front() != '0' &&
                           level.find_first_not_of("0123456789") == std::string::npos;
        if (!whole) {
            report.add(reader.place_of(level), "must be a level, a whole number from 1");
            continue;
        }
        read_points(reader, level, rubric.levels[std::stoi(level)] = 1, report);
    }
}

double factor(const Rubric& rubric, const Tally::Key& key) {
    const auto level = rubric.levels.find(key.level);
    return rubric.kinds[static_cast<std::size_t>(key.kind)] *
           (level == rubric.levels.end() ? 1 : level->second);
}

}  // namespace

Rubric read_rubric(const std::string& text, const std::filesystem::path& file) {
    JsonReport report;
    report.file = file.string();
    const Json document = parse_json(text, report.file);
    check_json_format(document, "raytree-rubric", 1, 0, report);
    const JsonPlace top;
    const ObjectReader reader(document, top, report);
    Rubric rubric;
    std::string name;
    reader.text("name", name, Need::optional);
    read_points(reader, "total", rubric.total, report);
    read_points(reader, "missing_ray", rubric.missing_ray, report);
    read_points(reader, "extra_ray", rubric.extra_ray, report);
    within(reader, "quantities", report, [&](const ObjectReader& quantities, const Json&) {
        for (std::size_t k = 0; k < field_count; ++k) {
            read_points(quantities, field_words[k], rubric.quantities[k], report);
        }
        quantities.nothing_but({field_words.begin(), field_words.end()});
    });
    within(reader, "kinds", report, [&](const ObjectReader& kinds, const Json&) {
        for (std::size_t k = 0; k < kind_words.size(); ++k) {
            read_points(kinds, kind_words[k], rubric.kinds[k], report);
        }
        kinds.nothing_but({kind_words.begin(), kind_words.end()});
    });
    within(reader, "levels", report, [&](const ObjectReader& levels, const Json& value) {
        read_levels(levels, value, rubric, report);
    });
    reader.nothing_but(
        {"format", "name", "total", "quantities", "kinds", "levels", "missing_ray", "extra_ray"});
    if (!report.mistakes.empty()) {
        throw InputError(std::move(report.mistakes));
    }
    return rubric;
}

Points points_of(const Report& report, const Rubric& rubric) {
    Points points;
    points.total = rubric.total;
    double earned = 0, possible = 0;
    const auto add = [&](std::string quantity, const Tally::Key& key, std::size_t compared,
                         std::size_t right, double each) {
        PointsRow row{
            std::move(quantity), std::string(word_of(key.kind)), key.level, compared, right, 0, 0};
        const double worth = each * factor(rubric, key);
        row.points = worth * static_cast<double>(right);
        row.of = worth * static_cast<double>(compared);
        earned += row.points;
        possible += row.of;
        points.rows.push_back(std::move(row));
    };
    for (const auto& [key, count] : report.tally.counts) {
        const std::size_t compared = std::max(count.compared, count.wrong);
        add(std::string(word_of(key.field)), key, compared, compared - count.wrong,
            rubric.quantities[place_of(key.field)]);
    }
    for (const auto& [key, rays] : report.tally.missing) {
        add("missing ray", key, rays, 0, rubric.missing_ray);
    }
    for (const auto& [key, rays] : report.tally.extra) {
        add("extra ray", key, rays, 0, rubric.extra_ray);
    }
    const bool none =
        std::ranges::all_of(points.rows, [](const PointsRow& row) { return row.compared == 0; });
    points.earned = report.verdict == Verdict::pass ? rubric.total
                    : none || possible == 0         ? 0
                                                    : rubric.total * earned / possible;
    return points;
}

}  // namespace raytree::check
