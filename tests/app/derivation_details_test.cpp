#include "state/derivation_details.h"

#include <doctest/doctest.h>

#include "app/scenes.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

const DetailSection* section_named(const std::vector<DetailSection>& sections,
                                   std::string_view title) {
    for (const DetailSection& section : sections) {
        if (section.title.starts_with(title)) {
            return &section;
        }
    }
    return nullptr;
}

TEST_CASE("app: every ray that ends at a sphere or a polygon says how, and which hit counts") {
    const auto document = test::document_of(test::glass_ball_scene());
    const auto tree = record_tree(document->world(), 40, 30);
    for (const auto& ray : tree.rays) {
        const auto sections = derivation_details(derive(document->world(), tree, ray.id));
        const bool ends = ray.hit || (ray.shadow && ray.shadow->blocked_by);
        CHECK((section_named(sections, "How the hit was found") != nullptr) == ends);
        CHECK(section_named(sections, "Media that the ray is in"));
        int counting = 0;
        if (const auto* along = section_named(sections, "All hits along the ray")) {
            for (const DetailRow& row : along->rows) {
                counting += row.cells.front().find("counts") != std::string::npos ? 1 : 0;
            }
        }
        CHECK(counting == (ends ? 1 : 0));
    }
}

TEST_CASE("app: of two roots the one taken stands out, and it is said why") {
    Derivation derivation;
    derivation.how = SphereDerivation{1, 0, -4, 16, {-2, 2}, 1};
    const auto section = derivation_details(derivation).front();
    REQUIRE(section.rows.size() == 6);
    CHECK(section.rows[4].weight == DetailRow::Weight::faint);
    CHECK(section.rows[5].weight == DetailRow::Weight::strong);
    CHECK(section.sentences.front().find("behind") != std::string::npos);
}

TEST_CASE("app: of very many hits along a ray, the first are listed and the others counted") {
    Derivation derivation;
    for (std::size_t k = 0; k < most_met + 3; ++k) {
        derivation.along.push_back({"shape", 1.0 + static_cast<double>(k), k == 0});
    }
    const auto sections = derivation_details(derivation);
    CHECK(sections.front().rows.size() == most_met);
    CHECK(sections.front().sentences.front() == "And 3 more.");
}

}  // namespace
}  // namespace raytree::inspector
