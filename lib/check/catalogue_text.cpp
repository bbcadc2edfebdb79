#include "check/catalogue_text.h"

#include <algorithm>

#include "check/catalogue.h"
#include "check/conventions.h"
#include "check/lessons.h"
#include "check/picture_mistakes.h"

namespace raytree::check {
namespace {

/// Text in a cell of a table.
std::string cell(std::string_view text) {
    std::string out;
    for (const char c : text) {
        out += c == '|' || c == '*' || c == '_' ? std::string("\\") + c : std::string(1, c);
    }
    return out;
}

std::string row_of(std::string_view id, std::string_view text, std::string_view topic) {
    return "| `" + std::string(id) + "` | " + cell(text) + " | " + cell(topic) + " | " +
           lesson_of(id).name() + " |\n";
}

std::string mistakes_text() {
    std::string text = "## Mistakes\n\n" + std::to_string(catalogue().size()) +
                       " in trees and pictures, " + std::to_string(picture_mistakes().size()) +
                       " more in pictures alone.\n\n"
                       "| name | what is wrong | topic | lesson |\n| --- | --- | --- | --- |\n";
    for (const MistakeRow& row : catalogue()) {
        text += row_of(row.id, row.text, row.topic);
    }
    for (const PictureMistakeRow& row : picture_mistakes()) {
        text += row_of(row.id, row.text, row.topic);
    }
    return text;
}

/// What students get wrong besides, and why it is no row of the catalogue.
struct Unseen {
    std::string_view id, why;
};
constexpr Unseen unseen[] = {
    {"refl.geometric_normal",
     "d - 2 (d . n) n is the same for n and -n: a normal that is not turned leaves no trace."},
    {"refl.not_normalised",
     "Reflection keeps the length of d: with a unit normal r is as long as d is, and what comes of "
     "a d that is not unit is `cam.dir_not_normalised`."},
    {"refr.schlick_wrong_cos",
     "The model has constants kr and kt and no Fresnel term. Shares that depend on the angle are "
     "seen as wrong intensities, and not named."},
    {"rec.same_pixel_state",
     "What one pixel leaves behind for the next is seen in pictures, or in the trees of several "
     "pixels, not in one tree."},
    {"parse.whitespace", "A program that dies on a blank line prints no tree."},
    {"shd.normalised_tmax1", "Called `shd.tmax_one_unit` here."},
    {"out.local_clamped", "Called `lit.clamped_early` here."},
    {"out.quantise_255.9",
     "With `out.quantise_round`: never more than one level off, which pictures may be; see the "
     "axis "
     "`quantise`."},
};

std::string unseen_text() {
    std::string text = "\n## What is not named\n\n| mistake | why |\n| --- | --- |\n";
    for (const Unseen& each : unseen) {
        text += "| `" + std::string(each.id) + "` | " + std::string(each.why) + " |\n";
    }
    return text;
}

std::string conventions_text() {
    std::string text =
        "\n## Conventions\n\nThe first value of each axis is the lecture's.\n\n"
        "| axis | value | meaning | where it is not meant, the mistake |\n"
        "| --- | --- | --- | --- |\n";
    for (const Convention& each : conventions()) {
        text += "| `" + std::string(each.axis) + "` | `" + std::string(each.value) + "` | " +
                cell(each.text) + " | " +
                (each.mistake.empty() ? "" : "`" + std::string(each.mistake) + "`") + " |\n";
    }
    return text;
}

std::string profiles_text() {
    std::string text =
        "\n## Profiles\n\n| name | meaning | other than the lecture |\n"
        "| --- | --- | --- |\n";
    for (const Profile& profile : profiles()) {
        std::string choices;
        for (const std::string_view choice : profile.named) {
            choices += (choices.empty() ? "`" : ", `") + std::string(choice) + '`';
        }
        text += "| `" + std::string(profile.name) + "` | " + cell(profile.text) + " | " + choices +
                " |\n";
    }
    return text;
}

}  // namespace

std::string catalogue_markdown() {
    return "# What raytree check knows\n\nMade from the tables in `lib/check` by `raytree check "
           "--catalogue`; a test holds it to them.\n\n" +
           mistakes_text() + unseen_text() + conventions_text() + profiles_text();
}

}  // namespace raytree::check
