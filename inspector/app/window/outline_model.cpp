#include "window/outline_model.h"

#include <QFont>

#include "formats/tree_diagram.h"
#include "tree/explain.h"
#include "window/icons.h"
#include "window/qt_text.h"

namespace raytree::inspector {

void OutlineModel::show(const State& state) {
    beginResetModel();
    state_ = &state;
    tree_ = state.tree();
    const Table& table = state.table();
    sorted_ = tree_ && table.sorted_by;
    rays_ = sorted_ ? sorted_rays(*tree_, *table.sorted_by, table.descending)
                    : std::vector<std::size_t>();
    places_.resize(rays_.size());
    for (std::size_t k = 0; k < rays_.size(); ++k) {
        places_[rays_[k]] = k;
    }
    outline_ = Outline(tree_, state.look().ghosts);
    theme_ = state.look().theme;
    quantize_ = state.document() ? state.document()->scene().settings.quantize : Quantize::round;
    for (std::size_t k = 0; k < look_count; ++k) {
        signs_[k] = sign_of(static_cast<RayLook>(k), palette_of(theme_));
    }
    for (std::size_t k = 0; k < ghost_signs_.size(); ++k) {
        ghost_signs_[k] = ghost_sign(static_cast<RayKind>(k), palette_of(theme_));
    }
    endResetModel();
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

QVariant OutlineModel::text(const OutlineRow& row, Column column) const {
    if (!row.skipped) {
        return qt(text_of(*tree_, row.ray, column));
    }
    const OutlineTexts texts = texts_of(*tree_, row);
    switch (column) {
        case Column::ray:
            return qt(texts.ray);
        case Column::met:
            return qt(texts.met);
        case Column::ended:
            return qt(short_reason(tree_->tree.rays[row.ray].skipped[*row.skipped].reason));
        default:
            return {};
    }
}

QVariant OutlineModel::icon(const OutlineRow& row, Column column) const {
    const Palette& palette = palette_of(theme_);
    if (column == Column::ray) {
        const TreeRay<double>& ray = tree_->tree.rays[row.ray];
        return row.skipped ? ghost_signs_[static_cast<std::size_t>(ray.skipped[*row.skipped].kind)]
                           : signs_[static_cast<std::size_t>(look_of(ray))];
    }
    if (const auto colour = swatch_of(*tree_, row); column == Column::intensity && colour) {
        const auto [r, g, b] = eight_bit(*colour, quantize_).value;
        return swatch(QColor(r, g, b), palette);
    }
    return {};
}

bool OutlineModel::is_faint(const OutlineRow& row, Column column) const {
    const RayFilter& filter = state_->look().filter;
    return row.skipped || column == Column::ended ||
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
            return row.skipped || column == Column::ended ? qt(texts_of(*tree_, row).ended)
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
            font.setItalic(row.skipped.has_value());
            font.setBold(column == Column::ray && is_marked(row));
            return row.skipped || font.bold() ? QVariant(font) : QVariant();
        }
        default:
            return {};
    }
}

QVariant OutlineModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    const ColumnText& text = text_of(static_cast<Column>(section));
    switch (role) {
        case Qt::TextAlignmentRole:
            return static_cast<int>(text.number ? Qt::AlignRight : Qt::AlignLeft);
        case Qt::DisplayRole:
            return qt(text.title);
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
