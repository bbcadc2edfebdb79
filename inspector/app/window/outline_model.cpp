#include "window/outline_model.h"

#include <QFont>

#include "formats/tree_diagram.h"
#include "state/marked_texts.h"
#include "state/numbers.h"
#include "tree/eight_bit.h"
#include "tree/explain.h"
#include "window/icons.h"
#include "window/qt_text.h"

namespace raytree::inspector {

void OutlineModel::show(const State& state) {
    beginResetModel();
    state_ = &state;
    tree_ = state.tree();
    const Table& table = state.table();
    sorted_ = tree_ && table.sorted_by && !state.playback();  // steps are taken along the tree
    rays_ = sorted_ ? sorted_rays(*tree_, *table.sorted_by, table.descending)
                    : std::vector<std::size_t>();
    places_.resize(rays_.size());
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        places_[rays_[k]] = k;
    }
    outline_ = Outline(tree_, state.look().ghosts, happened_rows(state.playback()));
    draw_signs(state.look().theme);
    quantize_ = state.document() ? state.document()->scene().settings.quantize : Quantize::round;
    endResetModel();
}

/// Once for each theme: they are drawn, and a tree is shown with every click.
void OutlineModel::draw_signs(Theme theme) {
    if (theme == theme_ && !signs_[0].isNull()) {
        return;
    }
    theme_ = theme;
    for (std::size_t k = 0; k < look_count; ++k) {
        signs_[k] = sign_of(static_cast<RayLook>(k), palette_of(theme_));
    }
    for (std::size_t k = 0; k < ghost_signs_.size(); ++k) {
        ghost_signs_[k] = ghost_sign(static_cast<RayKind>(k), palette_of(theme_));
    }
}

/// Of the outline, a row's place in it; of the sorted table, the ray.
QModelIndex OutlineModel::index_of(std::size_t place, int column) const {
    const std::size_t row = sorted_ ? places_[place] : outline_.row(place).place;
    return createIndex(static_cast<int>(row), column, static_cast<quintptr>(place));
}

OutlineRow OutlineModel::row(const QModelIndex& index) const {
    const auto place = static_cast<std::size_t>(index.internalId());
    if (!sorted_) {
        return outline_.row(place);
    }
    OutlineRow row;
    row.ray = place;
    return row;
}

QModelIndex OutlineModel::index_of_ray(std::size_t ray) const {
    return outline_.empty() ? QModelIndex() : index_of(sorted_ ? ray : outline_.row_of(ray), 0);
}

QModelIndex OutlineModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) {
        return {};
    }
    const auto place = static_cast<std::size_t>(row);
    if (sorted_) {
        return index_of(rays_[place], column);
    }
    return parent.isValid() ? index_of(outline_.children_of(parent.internalId())[place], column)
                            : index_of(0, column);
}

QModelIndex OutlineModel::parent(const QModelIndex& child) const {
    return sorted_ || child.internalId() == 0
               ? QModelIndex()
               : index_of(outline_.row(child.internalId()).parent, 0);
}

int OutlineModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) {
        return sorted_ ? static_cast<int>(rays_.size()) : outline_.empty() ? 0 : 1;
    }
    return sorted_ || parent.column() > 0
               ? 0
               : static_cast<int>(outline_.children_of(parent.internalId()).size());
}

/// Whether all is known of a ray: while the tree is stepped through, only what has happened.
bool OutlineModel::is_known(std::size_t ray) const {
    const auto& playback = state_->playback();
    return !playback || playback->stage(ray) == Stage::evaluated;
}

QVariant OutlineModel::text(const OutlineRow& row, Column column) const {
    const auto colour = swatch_of(*tree_, row);
    if (brief_ && column == Column::intensity && colour && is_known(row.ray)) {
        return qt(brief_rgb_text(*colour));
    }
    if (!row.skipped && is_known(row.ray) && column != Column::ray && column != Column::met) {
        return qt(text_of(*tree_, row.ray, column));
    }
    const OutlineTexts texts = marked_texts_of(*tree_, row, state_->playback());
    switch (column) {
        case Column::ray:
            return row.skipped ? qt(texts.ray)
                               : signed_briefly(qt(number_of(*tree_, row.ray) + "  " + texts.ray));
        case Column::t:
            return qt(texts.t);
        case Column::intensity:
            return qt(texts.intensity);
        case Column::met:
            return row.skipped
                       ? qt(texts.met + ": " +
                            short_reason(tree_->tree.rays[row.ray].skipped[*row.skipped].reason))
                       : qt(texts.met);
        case Column::ended:
            return row.skipped ? QString() : qt(texts.ended);
        default:
            return {};
    }
}

/// What follows a ray's name stands after three blanks: a sign and what it means.
QString OutlineModel::signed_briefly(const QString& text) const {
    if (!brief_) {
        return text;
    }
    QStringList parts = text.split(QStringLiteral("   "));
    for (int k = 1; k < parts.size(); ++k) {
        parts[k] = parts[k].section(QLatin1Char(' '), 0, 0);
    }
    return parts.join(QLatin1Char(' ')).replace(QStringLiteral("  "), QStringLiteral(" "));
}

QString OutlineModel::widest_ray() const {
    constexpr std::size_t longest_name = 20;
    if (!tree_) {
        return {};
    }
    std::string sent = "refracted", unsent;
    const auto add_shadow = [&](std::string& widest, const std::string& light) {
        if (light.size() <= longest_name && light.size() + 9 > widest.size()) {
            widest = "shadow → " + light;
        }
    };
    for (const TreeRay<double>& ray : tree_->tree.rays) {
        if (ray.shadow) {
            add_shadow(sent, ray.shadow->light);
        }
        for (const Skipped& skipped : ray.skipped) {
            if (skipped.kind == RayKind::shadow) {
                add_shadow(unsent, skipped.light);
            }
        }
    }
    const std::size_t last = tree_->tree.rays.size() - 1;
    const bool cut = tree_->contrast && tree_->contrast->what == Contrast::What::cut;
    const std::string mark = mark_text(cut ? RayMark::cut : RayMark::missing);
    const QString numbered = signed_briefly(
        qt((tree_->grafted > 0 ? "(#" : "#") + std::to_string(last) +
           (tree_->grafted > 0 ? ")" : "") + "  " + sent + (tree_->contrast ? "   " + mark : "") +
           (tree_->bounds ? "   ≈ in doubt" : "")));
    return numbered.size() > qt(unsent).size() ? numbered : qt(unsent);
}

QString OutlineModel::widest_met() const {
    std::string_view longest = "nothing";
    const auto meets = [&](const std::string& name) {
        longest = name.size() > longest.size() ? std::string_view(name) : longest;
    };
    if (tree_) {
        for (const TreeRay<double>& ray : tree_->tree.rays) {
            if (ray.hit) {
                meets(ray.hit->object);
            } else if (ray.shadow && ray.shadow->blocked_by) {
                meets(ray.shadow->blocked_by->object);
            }
        }
    }
    return qt(longest) + QStringLiteral(", back");
}

QVariant OutlineModel::icon(const OutlineRow& row, Column column) const {
    const Palette& palette = palette_of(theme_);
    if (column == Column::ray) {
        const TreeRay<double>& ray = tree_->tree.rays[row.ray];
        return row.skipped ? ghost_signs_[static_cast<std::size_t>(ray.skipped[*row.skipped].kind)]
                           : signs_[static_cast<std::size_t>(look_of(ray))];
    }
    const bool known = is_known(row.ray);
    if (const auto colour = swatch_of(*tree_, row);
        column == Column::intensity && colour && known) {
        const auto [r, g, b] = eight_bit(*colour, quantize_).value;
        return swatch(QColor(r, g, b), palette);
    }
    return {};
}

bool OutlineModel::is_faint(const OutlineRow& row, Column column) const {
    const RayFilter& filter = state_->look().filter;
    return row.skipped || column == Column::ended || !tree_->is_own(row.ray) ||
           (!filter.empty() && shown(filter, *tree_, tree_->tree.rays[row.ray]) != Shown::full);
}

/// Whether the ray has to do with the thing that is selected.
bool OutlineModel::is_marked(const OutlineRow& row) const {
    return !row.skipped && state_->thing() &&
           concerns(state_->document()->scene(), *state_->thing(), tree_->tree.rays[row.ray]);
}

QVariant OutlineModel::data(const QModelIndex& index, int role) const {
    const OutlineRow row = this->row(index);
    const auto column = static_cast<Column>(index.column());
    switch (role) {
        case Qt::DisplayRole:
            return text(row, column);
        case Qt::ToolTipRole:
            return row.skipped || column == Column::ended
                       ? qt(marked_texts_of(*tree_, row, state_->playback()).ended)
                       : text(row, column);
        case Qt::DecorationRole:
            return icon(row, column);
        case Qt::TextAlignmentRole:
            return text_of(column).number ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                          : QVariant();
        case Qt::ForegroundRole:
            return is_faint(row, column) ? QVariant(qt(palette_of(theme_).dim_text)) : QVariant();
        case Qt::BackgroundRole:
            return is_marked(row) ? QVariant(qt(palette_of(theme_).selection, 26)) : QVariant();
        case Qt::FontRole: {
            QFont font;
            font.setItalic(row.skipped || !tree_->is_own(row.ray));
            font.setBold(
                column == Column::ray &&
                (is_marked(row) || (!row.skipped && tree_->mark(row.ray) == RayMark::different)));
            return font.italic() || font.bold() ? QVariant(font) : QVariant();
        }
        default:
            return {};
    }
}

/// Which column the rays are sorted by is told by an arrow at the right of its title.
QString OutlineModel::room_for_arrow(int section) const {
    const bool sorted = state_ && state_->table().sorted_by == static_cast<Column>(section);
    return sorted ? QString(4, QChar(QChar::Nbsp)) : QString();
}

QVariant OutlineModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    const ColumnText& text = text_of(static_cast<Column>(section));
    switch (role) {
        case Qt::TextAlignmentRole:
            return static_cast<int>(Qt::AlignVCenter |
                                    (text.number ? Qt::AlignRight : Qt::AlignLeft));
        case Qt::DisplayRole:
            return qt(text.title) + room_for_arrow(section);
        case Qt::ToolTipRole:
            return qt(text.help) +
                   QStringLiteral("; a click sorts, the right button chooses columns");
        default:
            return {};
    }
}

Qt::ItemFlags OutlineModel::flags(const QModelIndex& index) const {
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::NoItemFlags;
}

}  // namespace raytree::inspector
