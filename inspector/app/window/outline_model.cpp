#include "window/outline_model.h"

#include <QFont>

#include "state/marked_texts.h"
#include "tree/explain.h"
#include "window/icons.h"
#include "window/qt_text.h"

namespace raytree::inspector {

void OutlineModel::show(std::shared_ptr<const PixelTree> tree, bool ghosts, Theme theme,
                        Quantize quantize) {
    beginResetModel();
    tree_ = std::move(tree);
    outline_ = Outline(tree_, ghosts, happened_rows(playback_));
    theme_ = theme;
    quantize_ = quantize;
    for (std::size_t k = 0; k < look_count; ++k) {
        signs_[k] = sign_of(static_cast<RayLook>(k), palette_of(theme));
    }
    for (std::size_t k = 0; k < ghost_signs_.size(); ++k) {
        ghost_signs_[k] = ghost_sign(static_cast<RayKind>(k), palette_of(theme));
    }
    endResetModel();
}

QModelIndex OutlineModel::index_of(std::size_t place, int column) const {
    return createIndex(static_cast<int>(outline_.row(place).place), column,
                       static_cast<quintptr>(place));
}

QModelIndex OutlineModel::index_of_ray(std::size_t ray) const {
    return outline_.empty() ? QModelIndex() : index_of(outline_.row_of(ray), 0);
}

QModelIndex OutlineModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) {
        return {};
    }
    if (!parent.isValid()) {
        return index_of(0, column);
    }
    return index_of(outline_.children_of(parent.internalId())[static_cast<std::size_t>(row)],
                    column);
}

QModelIndex OutlineModel::parent(const QModelIndex& child) const {
    return child.internalId() == 0 ? QModelIndex() : index_of(row(child).parent, 0);
}

int OutlineModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) {
        return outline_.empty() ? 0 : 1;
    }
    return parent.column() > 0 ? 0
                               : static_cast<int>(outline_.children_of(parent.internalId()).size());
}

QVariant OutlineModel::text(const OutlineRow& row, int column) const {
    const OutlineTexts texts = marked_texts_of(*tree_, row, playback_);
    switch (column) {
        case ray_column:
            return row.skipped ? qt(texts.ray) : qt(number_of(*tree_, row.ray) + "  " + texts.ray);
        case met_column:
            return qt(texts.met);
        case t_column:
            return qt(texts.t);
        case intensity_column:
            return qt(texts.intensity);
        default:
            return qt(texts.ended);
    }
}

QVariant OutlineModel::icon(const OutlineRow& row, int column) const {
    const Palette& palette = palette_of(theme_);
    if (column == ray_column) {
        const TreeRay<double>& ray = tree_->tree.rays[row.ray];
        return row.skipped ? ghost_signs_[static_cast<std::size_t>(ray.skipped[*row.skipped].kind)]
                           : signs_[static_cast<std::size_t>(look_of(ray))];
    }
    const bool known = !playback_ || playback_->stage(row.ray) == Stage::evaluated;
    if (const auto colour = swatch_of(*tree_, row); column == intensity_column && colour && known) {
        const auto [r, g, b] = eight_bit(*colour, quantize_).value;
        return swatch(QColor(r, g, b), palette);
    }
    return {};
}

QVariant OutlineModel::data(const QModelIndex& index, int role) const {
    const OutlineRow& row = this->row(index);
    switch (role) {
        case Qt::DisplayRole:
            return text(row, index.column());
        case Qt::ToolTipRole:
            return index.column() == ended_column || row.skipped ? text(row, ended_column)
                                                                 : text(row, index.column());
        case Qt::DecorationRole:
            return icon(row, index.column());
        case Qt::TextAlignmentRole:
            return index.column() == t_column ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                              : QVariant();
        case Qt::ForegroundRole:
            return row.skipped || index.column() == ended_column || !tree_->is_own(row.ray)
                       ? QVariant(qt(palette_of(theme_).dim_text))
                       : QVariant();
        case Qt::FontRole: {
            QFont font;
            font.setItalic(row.skipped || !tree_->is_own(row.ray));
            font.setBold(!row.skipped && tree_->mark(row.ray) == RayMark::different);
            return font.italic() || font.bold() ? QVariant(font) : QVariant();
        }
        default:
            return {};
    }
}

QVariant OutlineModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return static_cast<int>(section == t_column ? Qt::AlignRight : Qt::AlignLeft);
    }
    static const std::array<const char*, column_count> titles = {"Ray", "Meets", "t", "Intensity",
                                                                 "Why it ended"};
    return role == Qt::DisplayRole
               ? QVariant(QString::fromUtf8(titles[static_cast<std::size_t>(section)]))
               : QVariant();
}

Qt::ItemFlags OutlineModel::flags(const QModelIndex& index) const {
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable : Qt::NoItemFlags;
}

}  // namespace raytree::inspector
