#include "formats/tree_json.h"

#include <doctest/doctest.h>

#include "formats/json_parse.h"
#include "support/example_tree.h"
#include "tree/tree_cast.h"

using namespace raytree;

TEST_CASE("a tree is written in the order and the words of the format") {
    const Json document = parse_json(write_tree_json(test::example_tree()), "");
    std::vector<std::string> keys;
    for (const auto& [key, value] : document.items()) {
        keys.push_back(key);
    }
    CHECK(keys == std::vector<std::string>{"format", "generator", "scene", "pixel", "camera",
                                           "settings", "intensity", "counts", "rays"});
    CHECK(document["format"] == "raytree/1.0");
    CHECK(document["scene"].dump() ==
          R"({"name":"example","sha256":")" + std::string(64, 'a') + "\"}");
    CHECK(document["pixel"].dump() == "[3,4]");
    CHECK(document["counts"].dump() ==
          R"({"primary":1,"reflected":1,"refracted":1,"shadow":2,"levels":2,"lights":2,)"
          R"("full_tree":21,"intersection_tests":12})");
    CHECK(document["rays"].size() == 5);
}

TEST_CASE("each kind of ray has its own members") {
    const Json rays = parse_json(write_tree_json(test::example_tree()), "")["rays"];
    CHECK(rays[0].dump() ==
          R"({"id":0,"parent":null,"kind":"primary","level":1,"origin":[0,0,5],)"
          R"("direction":[0,0,-1],"weight":[1,1,1],"attenuation":1,)"
          R"("hit":{"object":"ball","material":"glass","t":4,"point":[0,0,1],)"
          R"("normal":[0.6,0,0.8],"side":"front","cos_incident":0.8,"eta":[1,1.5],)"
          R"("sin2_transmitted":0.16},"ambient":[0.1,0.1,0.1],"diffuse":[0.2,0.1,0.05],)"
          R"("specular":[0,0,0],"intensity":[0.425,0.325,0.375],"termination":null,)"
          R"("skipped":[{"kind":"shadow","light":"sun","reason":"light_behind_surface"}]})");
    CHECK(rays[2].dump() ==
          R"({"id":2,"parent":0,"kind":"reflected","level":2,"origin":[0,0,1],)"
          R"("direction":[0.96,0,0.28],"weight":[0.25,0.25,0.25],"attenuation":1,"hit":null,)"
          R"("intensity":[0.4,0.4,0.8],"termination":"no_intersection","skipped":[]})");
    CHECK(rays[4].dump() ==
          R"({"id":4,"parent":3,"kind":"shadow","light":"key","level":2,"origin":[0,0,-1],)"
          R"("direction":[0,1,0],"distance":9,"blocked_by":{"object":"wall","t":3},)"
          R"("transmittance":[0,0,0],"diffuse":[0,0,0],"specular":[0,0,0]})");
    CHECK(rays[1]["blocked_by"].is_null());
}

TEST_CASE("a surface that lets nothing through has no eta, a directional light no distance") {
    RayTree<double> tree = test::example_tree();
    tree.rays[0].hit->interface.reset();
    tree.rays[1].shadow->distance.reset();
    const Json rays = parse_json(write_tree_json(tree), "")["rays"];
    CHECK_FALSE(rays[0]["hit"].contains("eta"));
    CHECK_FALSE(rays[0]["hit"].contains("sin2_transmitted"));
    CHECK(rays[1]["distance"].is_null());
}

TEST_CASE("a scene without a digest has none, and can travel inside the tree") {
    RayTree<double> tree = test::example_tree();
    tree.scene_sha256.clear();
    Scene scene;
    scene.name = "inner";
    const Json document = parse_json(write_tree_json(tree, &scene), "");
    CHECK_FALSE(document["scene"].contains("sha256"));
    CHECK(document["scene"]["document"]["format"] == "raytree-scene/1.0");
    CHECK(document["scene"]["document"]["name"] == "inner");
}

TEST_CASE("every arithmetic writes the digits that it has") {
    RayTree<double> tree = test::example_tree();
    tree.rays[0].hit->t = 1.0 / 3;
    CHECK(write_tree_json(tree).find("\"t\": 0.3333333333333333,") != std::string::npos);

    RayTree<Quad> exact = tree_cast<Quad>(tree);
    exact.rays[0].hit->t = Quad(1) / 3;
    const std::string text = write_tree_json(exact);
    CHECK(text.find("\"t\": 0.333333333333333333333333333333333317,") != std::string::npos);
    CHECK(parse_json(text, "")["rays"][0]["hit"]["t"] == 1.0 / 3);

    const RayTree<float> rough = tree_cast<float>(tree);
    CHECK(parse_json(write_tree_json(rough), "")["rays"][0]["hit"]["t"] == 1.0F / 3);
}

TEST_CASE("lines of a written tree are no longer than 100 columns where names are short") {
    const std::string text = write_tree_json(test::example_tree());
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = text.find('\n', start);
        CHECK(end - start <= 100);
        start = end + 1;
    }
}
