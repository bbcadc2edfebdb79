#include "check/catalogue.h"

namespace raytree::check {

std::vector<LawChange> MistakeRow::ways() const {
    std::vector<LawChange> all{apply};
    for (const LawChange other : others) {
        if (other) {
            all.push_back(other);
        }
    }
    return all;
}

const std::vector<MistakeRow>& catalogue() {
    static const std::vector<MistakeRow> all = [] {
        std::vector<MistakeRow> rows;
        for (const auto family :
             {camera_mistakes(), sphere_mistakes(), hit_mistakes(), normal_mistakes(),
              shadow_mistakes(), light_mistakes(), fading_mistakes(), highlight_mistakes(),
              reflection_mistakes(), refraction_mistakes(), recursion_mistakes()}) {
            rows.insert(rows.end(), family.begin(), family.end());
        }
        return rows;
    }();
    return all;
}

const MistakeRow* find_mistake(std::string_view id) {
    for (const MistakeRow& row : catalogue()) {
        if (row.id == id) {
            return &row;
        }
    }
    return nullptr;
}

}  // namespace raytree::check
