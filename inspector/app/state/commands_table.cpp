#include "state/command_groups.h"
#include "state/ray_text.h"

namespace raytree::inspector {
namespace {

Column column_of(std::string_view word) {
    if (const auto column = column_from(word)) {
        return *column;
    }
    throw InputError("", "table", "there is no column '" + std::string(word) + "'");
}

void change(State& state, void (Table::*how)(Column), std::string_view word) {
    Table changed = state.table();
    (changed.*how)(column_of(word));
    state.change_table(changed);
}
void flip_column(State& state, std::string_view word) { change(state, &Table::flip, word); }
void sort_by(State& state, std::string_view word) {
    change(state, &Table::turn, word);
    if (const Column column = column_of(word); !state.table().has(column)) {
        change(state, &Table::flip, word);
    }
}

void as_tree(State& state, std::string_view) {
    Table changed = state.table();
    changed.sorted_by.reset();
    state.change_table(changed);
}
bool is_sorted(const State& state) { return state.table().sorted_by.has_value(); }

void first_columns(State& state, std::string_view) { state.change_table({}); }

bool outline_is_shown(const State& state) {
    return state.tree() && state.tree_pane().tab == TreePane::Tab::outline;
}

void copy_ray_as_text(State& state, std::string_view) {
    state.request(Request::copy_text, ray_as_text(state));
    state.say("Copied: the selected ray as text.");
}
void copy_ray_as_json(State& state, std::string_view) {
    state.request(Request::copy_text, ray_as_json(state));
    state.say("Copied: the selected ray as JSON.");
}

constexpr Command table[] = {
    {"table.column", "", "Show or hide a column", "", "Shows or leaves out a column of the table.",
     Argument::text, flip_column},
    {"table.sort", "", "Sort", "",
     "Sorts the table by a column; then the other way round; then not at all.", Argument::text,
     sort_by},
    {"table.columns", "Table", "Columns…", "Ctrl+Shift+L",
     "Chooses the columns of the table, and by which it is sorted.", none,
     ask<Request::choose_columns>, outline_is_shown},
    {"table.as_tree", "Table", "As a tree", "Ctrl+Shift+T",
     "Puts the sorted table's rays in the order of the tree again.", none, as_tree, is_sorted},
    {"table.first_columns", "Table", "Usual columns", "",
     "Gives the table the columns and the order that it has at first.", none, first_columns},
    {"copy.rows",
     "Table",
     "Copy the chosen rows",
     "Ctrl+C",
     "Copies the rows chosen in the table, every digit of their numbers.",
     none,
     ask<Request::copy_rows>,
     outline_is_shown,
     nullptr,
     {},
     true},
    {"copy.table", "Table", "Copy all rows", "Ctrl+Shift+X",
     "Copies the whole table, every digit of its numbers.", none, ask<Request::copy_table>,
     has_tree},
    {"copy.ray_text",
     "Table",
     "Copy the ray as text",
     "Ctrl+T",
     "Copies all that the details say of the selected ray, every digit of its numbers.",
     none,
     copy_ray_as_text,
     has_tree,
     nullptr,
     {},
     true},
    {"copy.ray_json", "Table", "Copy the ray as JSON", "Ctrl+J",
     "Copies the selected ray as it stands in a ray tree's file (raytree/1.0).", none,
     copy_ray_as_json, has_tree},
    {"copy.number", "Table", "Copy the number", "Ctrl+Shift+N",
     "Copies the number of the details that Tab or the mouse has chosen, every digit of it.", none,
     ask<Request::copy_number>, has_tree},
};

}  // namespace

std::span<const Command> table_commands() { return table; }

}  // namespace raytree::inspector
