#pragma once

#include <QAbstractItemModel>
#include <QIcon>
#include <array>
#include <memory>

#include "state/outline.h"
#include "state/playback.h"

namespace raytree::inspector {

/// The tree's outline as Qt's views ask for it.
class OutlineModel : public QAbstractItemModel {
    Q_OBJECT

  public:
    enum Column { ray_column, met_column, t_column, intensity_column, ended_column, column_count };

    explicit OutlineModel(QObject* parent = nullptr) : QAbstractItemModel(parent) {}

    void show(std::shared_ptr<const PixelTree> tree, bool ghosts, Theme theme, Quantize quantize);
    /// What is shown from the next `show` on: only what has happened by then.
    void follow(const std::optional<Playback>& playback) { playback_ = playback; }
    QModelIndex index_of_ray(std::size_t ray) const;
    const OutlineRow& row(const QModelIndex& index) const {
        return outline_.row(static_cast<std::size_t>(index.internalId()));
    }

    QModelIndex index(int row, int column, const QModelIndex& parent) const override;
    QModelIndex parent(const QModelIndex& child) const override;
    int rowCount(const QModelIndex& parent) const override;
    int columnCount(const QModelIndex&) const override { return column_count; }
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  private:
    QModelIndex index_of(std::size_t place, int column) const;
    QVariant text(const OutlineRow& row, int column) const;
    QVariant icon(const OutlineRow& row, int column) const;

    std::shared_ptr<const PixelTree> tree_;
    Outline outline_;
    std::optional<Playback> playback_;
    Theme theme_ = Theme::light;
    Quantize quantize_ = Quantize::round;
    std::array<QIcon, look_count> signs_;
    std::array<QIcon, 4> ghost_signs_;  ///< by RayKind
};

}  // namespace raytree::inspector
