#include <doctest/doctest.h>

#include "formats/tree_json.h"
#include "scene/input_error.h"
#include "support/example_tree.h"

using namespace raytree;

namespace {

using doctest::Approx;

/// A document with these rays; what the format needs besides is there.
ReadTree read_rays(const std::string& rays) {
    return read_tree_json(R"({"format": "raytree/1.0", "pixel": [1, 2], "rays": )" + rays + "}",
                          "tree.json");
}

/// The places of what is wrong with a document, with blanks between them.
std::string wrong_places(const std::string& document) {
    try {
        read_tree_json(document, "tree.json");
    } catch (const InputError& error) {
        std::string places;
        for (const Mistake& mistake : error.mistakes()) {
            CHECK(mistake.file == "tree.json");
            CHECK_FALSE(mistake.text.empty());
            places += (places.empty() ? "" : " ") + mistake.place;
        }
        return places;
    }
    return "nothing";
}
std::string wrong_rays(const std::string& rays) {
    return wrong_places(R"({"format": "raytree/1.0", "pixel": [1, 2], "rays": )" + rays + "}");
}

}  // namespace

TEST_CASE("what was written is read again") {
    const RayTree<double> tree = test::example_tree();
    const ReadTree read = read_tree_json(write_tree_json(tree), "tree.json");
    CHECK(write_tree_json(read.tree) == write_tree_json(tree));
    CHECK(read.has_camera);
    CHECK(read.has_settings);
    CHECK_FALSE(read.scene);
    CHECK(read.warnings.empty());
    CHECK(read.ids == std::vector<std::string>{"0", "1", "2", "3", "4"});
    // Known from the branches that were sent.
    CHECK(read.tree.rays[0].hit->kr == Rgb<double>(0.25));
    CHECK(read.tree.rays[0].hit->kt == Rgb<double>(0.5));
    CHECK(read.tree.rays[3].hit->kr == Rgb<double>(0));
}

TEST_CASE("numbers from which others follow that no double holds are refused with their ray") {
    const auto ray = [](const std::string& members) {
        return R"([{"id": 1, "kind": "primary", "direction": [1, 0, 0]}, {"id": 2, "parent": 1,
                    "kind": "reflected", )" +
               members + "}]";
    };
    CHECK(wrong_rays(ray(R"("direction": [0, 1e308, 1e308], "hit": {"t": 3})")) == "/rays/1");
    CHECK(wrong_rays(ray(R"("direction": [0, 0, 1], "hit": {"t": 1e308})")) == "nothing");
    // What is not judged, since the file does not say it, is not held against it either.
    CHECK(wrong_rays(ray(R"("direction": [0, 0, 1], "hit": {"t": 3, "eta": [1, 0]})")) ==
          "nothing");
}

TEST_CASE("a scene inside a tree is read with it") {
    Scene scene;
    scene.name = "inner";
    const ReadTree read =
        read_tree_json(write_tree_json(test::example_tree(), &scene), "tree.json");
    REQUIRE(read.scene);
    CHECK(read.scene->name == "inner");
}

TEST_CASE("a mistake inside the embedded scene is given by its place in the tree") {
    const auto with_document = [](const std::string& document) {
        return R"({"format": "raytree/1.0", "pixel": [1, 2], "rays": [{"kind": "primary"}],
                   "scene": {"document": )" +
               document + "}}";
    };
    CHECK(wrong_places(with_document(R"({"format": "raytree-scene/7.0"})")) ==
          "/scene/document/format");
    const std::string places =
        wrong_places(with_document(R"({"format": "raytree-scene/1.0", "camera": {"eye": [0, 0, 1],
            "look_at": [0, 0, 0], "width": 4, "height": 4, "horizontal_fov_degrees": 30},
            "lights": 3, "objects": []})"));
    CHECK(places == "/scene/document/lights");
}

TEST_CASE("one ray with its kind is enough") {
    const ReadTree read = read_rays(R"([{"kind": "primary"}])");
    REQUIRE(read.tree.rays.size() == 1);
    CHECK(read.tree.pixel_i == 1);
    CHECK(read.tree.pixel_j == 2);
    CHECK(read.tree.counts.primary == 1);
    CHECK(read.tree.counts.levels == 1);
    CHECK_FALSE(read.tree.rays[0].hit);
    CHECK_FALSE(read.has_camera);
    CHECK_FALSE(read.has_settings);
}

TEST_CASE("rays come in any order, with numbers or strings as ids") {
    const ReadTree read = read_rays(R"([
        {"id": "t", "parent": 7.0, "kind": "refracted"},
        {"id": "s", "parent": "t", "kind": "shadow"},
        {"id": 3, "parent": 7, "kind": "reflected"},
        {"id": 7, "parent": null, "kind": "primary"},
        {"id": -1, "parent": 7, "kind": "shadow"}])");
    CHECK(read.ids == std::vector<std::string>{"7", "-1", "3", "t", "s"});
    CHECK(read.tree.rays[4].parent == 3);
    CHECK(read.tree.rays[4].level == 2);
    CHECK(read.tree.rays[3].level == 2);
    CHECK(read.tree.counts.shadow == 2);
}

TEST_CASE("rays may be nested, with or without ids") {
    const ReadTree read = read_rays(R"([{"kind": "primary", "children": [
        {"kind": "refracted", "children": [{"kind": "reflected"}, {"kind": "shadow"}]},
        {"kind": "reflected", "children": []}]}])");
    REQUIRE(read.tree.rays.size() == 5);
    CHECK(read.tree.rays[1].kind == RayKind::reflected);
    CHECK(read.tree.rays[2].kind == RayKind::refracted);
    CHECK(read.tree.rays[3].kind == RayKind::shadow);
    CHECK(read.tree.rays[4].parent == 2);
    CHECK(read.tree.counts.levels == 3);
}

TEST_CASE("a direction that is not unit is made so, and t with it") {
    const ReadTree read = read_rays(R"([{"kind": "primary", "origin": [0, 0, 5],
        "direction": [0, 0, -2], "hit": {"t": 1.5, "normal": [0, 0, 1]}},
        {"parent": 0, "kind": "shadow", "direction": [0, 4, 0], "distance": 9,
         "blocked_by": {"object": "x", "t": 0.5}}])");
    const TreeRay<double>& ray = read.tree.rays[0];
    CHECK(ray.direction == Vec3<double>(0, 0, -1));
    CHECK(ray.hit->t == 3);
    CHECK(ray.hit->point == Vec3<double>(0, 0, 2));
    CHECK(ray.hit->cos_incident == 1);
    CHECK(read.tree.rays[1].origin == ray.hit->point);
    CHECK(read.tree.rays[1].shadow->blocked_by->t == 2);
    CHECK(read.tree.rays[1].shadow->distance == 9);
    CHECK(read.tree.rays[1].shadow->transmittance == Rgb<double>(0));
}

TEST_CASE("a hit's distance follows from its point") {
    const ReadTree read = read_rays(R"([{"kind": "primary", "origin": [0, 0, 5],
        "direction": [0, 0, -1], "hit": {"point": [0, 0, 1]}}])");
    CHECK(read.tree.rays[0].hit->t == 4);
}

TEST_CASE("a ray with others below it hit something") {
    const ReadTree read = read_rays(R"([{"kind": "primary", "origin": [0, 0, 5]},
        {"parent": 0, "kind": "reflected", "origin": [0, 0, 2], "weight": [0.5, 0, 0]}])");
    REQUIRE(read.tree.rays[0].hit);
    CHECK(read.tree.rays[0].hit->t == 3);
    CHECK(read.tree.rays[0].hit->kr.r == 0.5);
}

TEST_CASE("the share that f and the parent's share leave gives the coefficient") {
    const ReadTree read = read_rays(R"([{"kind": "primary"},
        {"id": 1, "parent": 0, "kind": "refracted", "weight": [0.5, 0.5, 0], "attenuation": 0.5},
        {"id": 2, "parent": 1, "kind": "reflected", "weight": [0.05, 0.1, 0]}])");
    const Rgb<double>& kr = read.tree.rays[1].hit->kr;
    CHECK(kr.r == Approx(0.2));
    CHECK(kr.g == Approx(0.4));
    CHECK(kr.b == 0);
}

TEST_CASE("unknown keys and nulls are left alone") {
    const ReadTree read = read_rays(R"([{"kind": "primary", "mood": [1, {}], "hit": null,
        "direction": null, "intensity": 0.5, "termination": null, "skipped": null}])");
    CHECK(read.tree.intensity == Rgb<double>(0.5));
    CHECK(read.warnings.empty());
}

TEST_CASE("what is no tree is refused with its place") {
    CHECK(wrong_rays("[]") == "/rays");
    CHECK(wrong_rays("{}") == "/rays");
    CHECK(wrong_rays("[3]") == "/rays/0");
    CHECK(wrong_rays(R"([{}])") == "/rays/0/kind");
    CHECK(wrong_rays(R"([{"kind": "mirror"}])") == "/rays/0/kind");
    CHECK(wrong_rays(R"([{"kind": "reflected"}])") == "/rays/0/kind");
    CHECK(wrong_rays(R"([{"kind": "primary"}, {"kind": "primary"}])") == "/rays/1");
    CHECK(wrong_rays(R"([{"kind": "primary"}, {"kind": "shadow", "parent": 9}])") ==
          "/rays/1/parent");
    CHECK(
        wrong_rays(R"([{"kind": "primary", "id": 1}, {"kind": "shadow", "id": 1, "parent": 1}])") ==
        "/rays/1/id");
    CHECK(wrong_rays(R"([{"kind": "primary", "id": []}])") == "/rays/0/id");
    CHECK(wrong_rays(R"([{"kind": "primary"}, {"kind": "primary", "parent": 0}])") ==
          "/rays/1/kind");
    CHECK(wrong_rays(R"([{"kind": "primary", "children": 3}])") == "/rays/0/children");
}

TEST_CASE("circles, rays below shadow rays and contradictions are refused") {
    CHECK(wrong_rays(R"([{"kind": "primary"}, {"id": "a", "parent": "b", "kind": "reflected"},
                         {"id": "b", "parent": "a", "kind": "reflected"}])") == "/rays/1 /rays/2");
    CHECK(wrong_rays(R"([{"id": 0, "kind": "primary", "parent": 0}])") == "/rays/0/kind /rays");
    CHECK(wrong_rays(R"([{"kind": "primary"}, {"parent": 0, "kind": "shadow"},
                         {"parent": 1, "kind": "reflected"}])") == "/rays/2");
    CHECK(wrong_rays(R"([{"id": 0, "kind": "primary", "children":
                          [{"id": 5, "parent": 3, "kind": "reflected"}]}])") ==
          "/rays/0/children/0/parent");
}

TEST_CASE("wrong types are refused with their place") {
    const auto with = [](const std::string& members) {
        return wrong_rays(R"([{"kind": "primary", )" + members + "}]");
    };
    CHECK(with(R"("origin": [0, 0])") == "/rays/0/origin");
    CHECK(with(R"("direction": "up")") == "/rays/0/direction");
    CHECK(with(R"("hit": 3)") == "/rays/0/hit");
    CHECK(with(R"("hit": {"t": "far", "side": "left"})") == "/rays/0/hit/t /rays/0/hit/side");
    CHECK(with(R"("termination": "tired")") == "/rays/0/termination");
    CHECK(with(R"("skipped": [{"kind": "shadow", "reason": "x"}])") == "/rays/0/skipped/0/reason");
    CHECK(with(R"("skipped": 1)") == "/rays/0/skipped");
    CHECK(with(R"("intensity": [1, 2, null])") == "/rays/0/intensity/2");
}

TEST_CASE("the head of a document is checked") {
    CHECK(wrong_places("[]") == "");
    CHECK(wrong_places("{}") == "/format");
    CHECK(wrong_places(R"({"format": "raytree/2.0"})") == "/format");
    CHECK(wrong_places(R"({"format": "raytree/1.0"})") == "/pixel /rays");
    const std::string rays = R"("rays": [{"kind": "primary"}]})";
    CHECK(wrong_places(R"({"format": "raytree/1.0", "pixel": [1, 2.5], )" + rays) == "/pixel");
    CHECK(wrong_places(R"({"format": "raytree/1.0", "pixel": [1, -2], )" + rays) == "/pixel");
    CHECK(wrong_places(R"({"format": "raytree/1.0", "pixel": [1, 2], "settings": 4, )" + rays) ==
          "/settings");
}

TEST_CASE("a newer minor version is read with a warning") {
    const ReadTree read = read_tree_json(
        R"({"format": "raytree/1.7", "pixel": [0, 0], "rays": [{"kind": "primary"}]})", "t");
    CHECK(read.warnings.size() == 1);
}

TEST_CASE("trees that are absurdly deep are refused, nested or not") {
    std::string flat = R"([{"id": 0, "kind": "primary"})";
    for (int k = 1; k < 100000; ++k) {
        flat += R"(, {"kind": "reflected", "id": )" + std::to_string(k) + R"(, "parent": )" +
                std::to_string(k - 1) + "}";
    }
    CHECK(wrong_rays(flat + "]") == "/rays/1000");

    std::string nested = R"({"kind": "primary")";
    for (int k = 1; k < 100000; ++k) {
        nested += R"(, "children": [{"kind": "reflected")";
    }
    CHECK(wrong_rays("[" + nested).starts_with("/rays/0/children/0/children/0/"));

    std::string deep = R"({"kind": "primary")", end = "}";
    for (int k = 1; k < 1000; ++k) {
        deep += R"(, "children": [{"kind": "reflected")";
        end += "]}";
    }
    CHECK(read_rays("[" + deep + end + "]").tree.counts.levels == 1000);
}

TEST_CASE("of very many mistakes the first are told") {
    std::string rays = R"([{"kind": "primary"})";
    for (int k = 1; k < 1000; ++k) {
        rays += R"(, {"kind": "wrong", "parent": 0})";
    }
    CHECK(wrong_rays(rays + "]").ends_with(" /rays/20/kind"));
}
