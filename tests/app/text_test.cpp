#include <doctest/doctest.h>

#include <algorithm>

#include "app/scenes.h"
#include "state/details.h"
#include "state/lighting_details.h"
#include "state/numbers.h"
#include "state/outline.h"
#include "state/picture.h"
#include "tree/eight_bit.h"
#include "tree/explain.h"
#include "tree/record.h"

namespace raytree::inspector {
namespace {

PixelTree ball_tree() {
    const auto document = test::document_of(test::glass_ball_scene());
    PixelTree tree;
    tree.tree = record_tree(document->world(), 40, 30);
    tree.children = children_of(tree.tree);
    return tree;
}

const DetailRow* find_row(const std::vector<DetailSection>& sections, const std::string& label) {
    for (const DetailSection& section : sections) {
        for (const DetailRow& row : section.rows) {
            if (row.label == label) {
                return &row;
            }
        }
    }
    return nullptr;
}

TEST_CASE("app: what a sum does not notice is shown as 0, and copied with its digits") {
    PixelTree tree = ball_tree();
    TreeRay<double>& ray = tree.tree.rays[0];
    REQUIRE(ray.hit);
    ray.intensity = {0.5, 0.25, 0.75};
    ray.specular = {2e-141, 0.25 * 1e-15, 1e-39};
    const auto sections = details_of(tree, 0);
    const DetailRow* const row = find_row(sections, "+ specular");
    REQUIRE(row);
    CHECK(row->cells[0] == "0");
    CHECK(row->cells[1] != "0");  // 0.25 + 0.25e-15 is not 0.25
    CHECK(row->cells[2] == "0");
    CHECK(row->values == std::vector<double>{2e-141, 0.25 * 1e-15, 1e-39});
    // Little of it has its decimals, so that the column is no wider for it.
    ray.specular = {4.35e-13, 0.02, 3e-4};
    const auto some = details_of(tree, 0);
    CHECK(find_row(some, "+ specular")->cells ==
          std::vector<std::string>{"0.00000", "0.02000", "0.00030"});
    ray.specular = Rgb<double>(4.35e-13);
    const auto little = details_of(tree, 0);
    CHECK(find_row(little, "+ specular")->cells == std::vector<std::string>(3, "0.00000"));
    CHECK(find_row(little, "+ specular")->values == std::vector<double>(3, 4.35e-13));
    // Of an intensity that is as small, it is all there is.
    ray.intensity = ray.specular;
    const auto small = details_of(tree, 0);
    CHECK(find_row(small, "+ specular")->cells[0] != "0");
    // What a shadow ray adds is measured by the intensity that it adds to.
    for (TreeRay<double>& shadow : tree.tree.rays) {
        if (shadow.shadow && shadow.parent == std::optional<std::size_t>(0)) {
            tree.tree.rays[0].intensity = Rgb<double>(0.5);
            shadow.specular = Rgb<double>(1e-39);
            const auto added = details_of(tree, shadow.id);
            CHECK(find_row(added, "+ specular")->cells[0] == "0");
        }
    }
}

TEST_CASE("app: details say where kt is added to kr") {
    PixelTree tree = ball_tree();
    TreeRay<double>& ray = tree.tree.rays[0];
    REQUIRE(ray.hit);
    REQUIRE(ray.hit->interface);
    REQUIRE(find_row(details_of(tree, 0), "+ kr·f·Ir"));
    const Rgb<double> kr = ray.hit->kr;
    ray.hit->interface = Interface<double>{1.5, 1, 1.2};
    CHECK(find_row(details_of(tree, 0), "   kr"));  // a lecture that drops the light
    tree.tree.settings.total_internal_reflection = TotalReflection::reflect;
    const auto sections = details_of(tree, 0);
    CHECK(find_row(sections, "+ (kr+kt)·f·Ir"));
    const DetailRow* const sum = find_row(sections, "   kr + kt");
    REQUIRE(sum);
    CHECK(sum->values == std::vector<double>{kr.r, kr.g, kr.b});
    const auto refraction = std::ranges::find(sections, "Refraction", &DetailSection::title);
    REQUIRE(refraction != sections.end());
    REQUIRE(refraction->sentences.size() == 1);
    CHECK(refraction->sentences[0].find("kt is added to kr") != std::string::npos);
}

TEST_CASE("app: the terms of illumination are told with their factors, and give the recorded sum") {
    for (const SpecularModel model : {SpecularModel::phong, SpecularModel::blinn}) {
        for (const ShadowMode shadows : {ShadowMode::transmissive, ShadowMode::none}) {
            Scene scene = test::glass_ball_scene();
            scene.settings.specular_model = model;
            scene.settings.shadows = shadows;
            for (Material& material : scene.materials) {
                material.ka = Rgb<double>(0.2, 0.1, 0.3);
                material.kd = Rgb<double>(0.5, 0.6, 0.7);
                material.ks = Rgb<double>(0.4);
                material.shininess = 3;
            }
            std::get<PointLight>(scene.lights[0].kind).attenuation = {1, 0.1, 0.02};
            const auto document = test::document_of(scene);
            PixelTree tree;
            tree.tree = record_tree(document->world(), 40, 30);
            tree.children = children_of(tree.tree);
            const auto values = [](const DetailSection& section, const std::string& label) {
                const auto row = std::ranges::find(section.rows, label, &DetailRow::label);
                return row == section.rows.end() ? std::vector<double>{0, 0, 0} : row->values;
            };
            const auto alike = [](const std::vector<double>& told, const Rgb<double>& recorded) {
                CHECK(told[0] == doctest::Approx(recorded.r).epsilon(1e-9));
                CHECK(told[1] == doctest::Approx(recorded.g).epsilon(1e-9));
                CHECK(told[2] == doctest::Approx(recorded.b).epsilon(1e-9));
            };
            int told = 0;
            for (const TreeRay<double>& ray : tree.tree.rays) {
                const auto sections = lighting_details(*document, tree, ray.id);
                if (ray.shadow) {
                    REQUIRE(sections.size() == 1);
                    alike(values(sections[0], "diffuse"), ray.diffuse);
                    alike(values(sections[0], "specular"), ray.specular);
                    ++told;
                } else if (ray.hit) {
                    alike(values(sections.at(0), "ambient"), ray.ambient);
                    if (shadows == ShadowMode::none) {
                        Rgb<double> diffuse(0), specular(0);
                        for (std::size_t k = 1; k < sections.size(); ++k) {
                            const auto d = values(sections[k], "diffuse");
                            const auto s = values(sections[k], "specular");
                            diffuse = diffuse + Rgb<double>(d[0], d[1], d[2]);
                            specular = specular + Rgb<double>(s[0], s[1], s[2]);
                        }
                        alike({diffuse.r, diffuse.g, diffuse.b}, ray.diffuse);
                        alike({specular.r, specular.g, specular.b}, ray.specular);
                        ++told;
                    }
                }
            }
            CHECK(told > 1);
        }
    }
}

TEST_CASE("app: numbers in a column have the same decimals") {
    CHECK(aligned(Vec3<double>(1, -22.5, 0)) ==
          std::vector<std::string>{"1.0000", "-22.5000", "0"});
    CHECK(aligned(std::array{0.25}) == std::vector<std::string>{"0.25000"});
    CHECK(aligned(std::array{1e-9}) == std::vector<std::string>{"1.00e-09"});
    CHECK(aligned(std::array{1.5e9}) == std::vector<std::string>{"1.50e+09"});
    CHECK(rgb_text({0.5, 1, 2.25}) == "0.500  1.000  2.250");
    CHECK(aligned(Vec3<double>(-1e-17, 1, -0.0)) ==
          std::vector<std::string>{"0.00000", "1.00000", "0"});
    CHECK(rgb_text({-1e-17, 0.5, -0.25}) == "0.000  0.500  -0.250");
    CHECK(grouped(1234567) == "1,234,567");
    CHECK(grouped(12) == "12");
}

/// All rows of an outline, each after its parent.
std::vector<std::size_t> all_rows(const Outline& outline) {
    std::vector<std::size_t> rows = {0};
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const auto& children = outline.children_of(rows[k]);
        rows.insert(rows.end(), children.begin(), children.end());
    }
    return rows;
}

TEST_CASE("app: the outline has every ray once, under its parent, in order") {
    const auto tree = std::make_shared<PixelTree>(ball_tree());
    const Outline outline(tree, true);
    std::vector<int> seen(tree->tree.rays.size());
    for (const std::size_t k : all_rows(outline)) {
        const OutlineRow& row = outline.row(k);
        if (row.skipped) {
            CHECK(outline.row(row.parent).ray == row.ray);
            continue;
        }
        ++seen[row.ray];
        CHECK(outline.row_of(row.ray) == k);
        if (k > 0) {
            CHECK(outline.row(row.parent).ray == tree->tree.rays[row.ray].parent);
            CHECK(outline.children_of(row.parent)[row.place] == k);
        }
    }
    CHECK(std::ranges::all_of(seen, [](int n) { return n == 1; }));
}

TEST_CASE("app: a row deep in the outline is found before those above it are looked at") {
    const auto tree = std::make_shared<PixelTree>(ball_tree());
    const std::size_t last = tree->tree.rays.size() - 1;
    const Outline outline(tree, true);
    CHECK(outline.row(outline.row_of(last)).ray == last);
    CHECK(Outline(nullptr, true).empty());
}

TEST_CASE("app: the outline has a ghost for every ray that was not sent, if wanted") {
    const auto tree = std::make_shared<PixelTree>(ball_tree());
    const auto& rays = tree->tree.rays;
    std::size_t skipped = 0;
    for (const auto& ray : rays) {
        skipped += static_cast<std::size_t>(std::ranges::count_if(
            ray.skipped, [&](const Skipped& s) { return !told_by_termination(ray, s); }));
    }
    REQUIRE(skipped > 0);
    const Outline with(tree, true), without(tree, false);
    CHECK(all_rows(with).size() == rays.size() + skipped);
    CHECK(all_rows(without).size() == rays.size());
    for (const std::size_t k : all_rows(with)) {
        const OutlineRow& row = with.row(k);
        if (row.skipped) {
            const OutlineTexts texts = texts_of(*tree, row);
            CHECK(texts.met == "not sent");
            CHECK(texts.ended ==
                  skipped_text(tree->tree, rays[row.ray], rays[row.ray].skipped[*row.skipped]));
            CHECK_FALSE(swatch_of(*tree, row));
        }
    }
}

TEST_CASE("app: the details' sum has the terms of the equation") {
    const PixelTree tree = ball_tree();
    const auto sections = details_of(tree, 0);
    for (const char* label : {"ambient", "+ diffuse", "+ specular", "+ kr·f·Ir", "+ kt·f·It",
                              "= intensity", "normal n", "origin", "direction", "weight"}) {
        CHECK_MESSAGE(find_row(sections, label), label);
    }
    CHECK(find_row(sections, "= intensity")->cells == aligned(tree.tree.intensity));
    CHECK(find_row(sections, "η1 → η2")->cells == std::vector<std::string>{"1 → 1.5"});
}

TEST_CASE("app: details of every ray say what it is and why it ended") {
    const PixelTree tree = ball_tree();
    for (const auto& ray : tree.tree.rays) {
        const auto sections = details_of(tree, ray.id);
        CHECK(sections.size() >= 3);
        if (ray.shadow) {
            CHECK(find_row(sections, "light")->cells.front() == ray.shadow->light);
            CHECK((find_row(sections, "blocked by") != nullptr) ==
                  ray.shadow->blocked_by.has_value());
        } else if (ray.termination) {
            CHECK(sections[1].title == "Where it ends");
            CHECK(sections[1].sentences.front().find(
                      text_of(*ray.termination).sentence.substr(1)) != std::string::npos);
        }
    }
}

TEST_CASE("app: the status says what was clamped and the bound on the rays") {
    CHECK(value_text({0.5, 1.5, 0}, Quantize::floor) ==
          "0.500  1.500  0.000  →  127 255 0  (green clamped)");
    const PixelTree tree = ball_tree();
    CHECK(counts_text(tree.tree).find("(2 + 1)(2^4 − 1) = 45") != std::string::npos);
}

TEST_CASE("app: the picture that comes in bit by bit is the rendered one in the end") {
    const auto document = test::document_of(test::glass_ball_scene());
    PictureRender render(document);
    while (!render.stopped()) {
        std::this_thread::yield();
    }
    REQUIRE(render.done());
    const ShownPicture shown = render.snapshot();
    REQUIRE(shown.width == 80);
    REQUIRE(shown.stride == 1);
    for (const Pixel pixel : {Pixel{0, 0}, {40, 30}, {79, 59}, {13, 47}}) {
        const auto tree = record_tree(document->world(), pixel.i, pixel.j);
        CHECK(render.intensity(pixel) == tree.intensity);
        const auto [r, g, b] = eight_bit(tree.intensity, Quantize::round).value;
        const auto cell = shown.cells[static_cast<std::size_t>(pixel.j * 80 + pixel.i)];
        CHECK(cell == (0xFF000000u | static_cast<unsigned>(r << 16 | g << 8 | b)));
    }
}

TEST_CASE("app: a picture of very many pixels is thinned out, and a cancelled one ends") {
    Scene scene = test::glass_ball_scene();
    scene.camera.width = 20'000;
    scene.camera.height = 10'000;
    PictureRender render(test::document_of(scene));
    CHECK(render.snapshot().stride == 6);
    render.cancel();
    while (!render.stopped()) {
        std::this_thread::yield();
    }
    CHECK_FALSE(render.done());
    CHECK_FALSE(render.intensity({1, 1}));
}

}  // namespace
}  // namespace raytree::inspector
