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
           mistakes_text() + conventions_text() + profiles_text();
}

}  // namespace raytree::check
