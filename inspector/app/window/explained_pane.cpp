#include "window/explained_pane.h"

#include <QAbstractTextDocumentLayout>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextTable>
#include <algorithm>
#include <cmath>

#include "state/commands.h"
#include "state/explained_text.h"
#include "window/explained_pictures.h"
#include "window/qt_text.h"
#include "window/rich_text.h"

namespace raytree::inspector {
namespace {

/// "1,599", "–" or "6.955 µs".
bool is_number(const std::string& cell) {
    static const QRegularExpression number(
        QStringLiteral("^([-−+]?[0-9][0-9.,]*(e[-+]?[0-9]+)?( [mµ]s)?|–|exact)$"));
    return number.match(qt(cell)).hasMatch();
}

/// Numbers below each other end below each other.
bool is_column_of_numbers(const ExplainedSection& section, std::size_t column) {
    return std::ranges::all_of(section.rows, [&](const ExplainedSection::Row& row) {
        return column >= row.cells.size() || row.cells[column].empty() ||
               is_number(row.cells[column]);
    });
}

QString table_of(const ExplainedSection& section, const Palette& palette) {
    if (section.rows.empty()) {
        return {};
    }
    const QString dim = qt(palette.dim_text).name();
    std::size_t columns = section.header.size();
    for (const ExplainedSection::Row& row : section.rows) {
        columns = std::max(columns, row.cells.size());
    }
    QStringList sides;
    for (std::size_t k = 0; k < columns; ++k) {
        sides << (is_column_of_numbers(section, k) ? QStringLiteral("right")
                                                   : QStringLiteral("left"));
    }
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='2'>");
    const auto row = [&](const std::vector<std::string>& cells, const QString& style,
                         const char* anchor = "") {
        html += QStringLiteral("<tr>");
        for (std::size_t k = 0; k < cells.size(); ++k) {
            constexpr std::size_t long_words = 34;
            html += QStringLiteral("<td align='%1' style='padding-right:16px; %2%3'>%4</td>")
                        .arg(sides[static_cast<int>(k)],
                             cells[k].size() > long_words ? QString()
                                                          : QStringLiteral("white-space:nowrap; "),
                             style, QLatin1String(anchor) + qt(cells[k]).toHtmlEscaped());
            anchor = "";
        }
        html += QStringLiteral("</tr>");
    };
    if (!section.header.empty()) {
        row(section.header, QStringLiteral("color:") + dim);
    }
    for (const ExplainedSection::Row& line : section.rows) {
        row(line.cells,
            line.strong ? QStringLiteral("font-weight:bold; background-color:%1")
                              .arg(qt(mixed(palette.panel, palette.accent, 0.12)).name())
            : line.faint ? QStringLiteral("color:") + dim
                         : QString(),
            line.strong ? "<a name='now'></a>" : "");
    }
    return html + QStringLiteral("</table>");
}

QString html_of(const ExplainedSection& section, const Palette& palette) {
    QString html = QStringLiteral("<p style='margin:0 0 3px 0; color:%1'><b>%2</b>")
                       .arg(qt(palette.accent).name(), qt(section.title).toHtmlEscaped());
    for (const ExplainedSection::Link& link : section.links) {
        html += QStringLiteral("&nbsp;&nbsp; <a href='%1' style='color:%2'>%3</a>")
                    .arg(qt(link.command), qt(palette.accent).name(),
                         qt(link.words).replace(QLatin1Char(' '), QStringLiteral("&nbsp;")));
    }
    html += QStringLiteral("</p>") + table_of(section, palette);
    for (const std::string& sentence : section.sentences) {
        html += QStringLiteral("<p style='margin:3px 0 3px 0; color:%1'>%2</p>")
                    .arg(qt(palette.dim_text).name(), qt(sentence).toHtmlEscaped());
    }
    return html;
}

/// What can be explained, to be clicked.
QString all_html(const State& state, const Palette& palette) {
    const QString dim = qt(palette.dim_text).name(), accent = qt(palette.accent).name();
    QString html = QStringLiteral(
                       "<p style='margin:0 0 6px 0; color:%1'>Choose what is to be "
                       "explained; the menu <b>Explain</b> has the same.</p>")
                       .arg(dim);
    for (const Command& command : commands()) {
        if (command.menu != "Explain" || !command.on) {
            continue;
        }
        const bool possible = !command.possible || command.possible(state);
        const QString title = qt(command.title).toHtmlEscaped();
        const QString link = possible ? QStringLiteral("<a href='%1' style='color:%2'>%3</a>")
                                            .arg(qt(command.id), accent, title)
                                      : title;
        html += QStringLiteral("<p style='margin:0 0 3px 0; color:%1'>%2 – %3</p>")
                    .arg(dim, link, qt(command.help).toHtmlEscaped());
    }
    return html;
}

}  // namespace

ExplainedPane::ExplainedPane(State& state, QWidget* parent) : QTextBrowser(parent), state_(state) {
    setOpenLinks(false);
    document()->setDocumentMargin(10);
    connect(this, &QTextBrowser::anchorClicked, this,
            [this](const QUrl& to) { run_command(state_, to.path().toStdString()); });
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &ExplainedPane::bring_along);
    state_.observe([this](const Changes& changes) {
        if (isVisible() && (changes.explained || changes.tree || changes.selection ||
                            changes.document || changes.look)) {
            renew();
        }
    });
}

void ExplainedPane::showEvent(QShowEvent* event) {
    renew();
    QTextBrowser::showEvent(event);
}

/// Sections beside each other; the light's depth picture before its numbers.
void ExplainedPane::renew() {
    shown_size_ = size();
    const Palette& palette = palette_of(state_.look().theme);
    const auto sections = explained_text(state_);
    if (sections.empty()) {
        setHtml(all_html(state_, palette));
        return;
    }
    // Beside each other where there is room, else below each other; pictures take what is left.
    picture_room_ = viewport()->width();
    show_html(*this, html_of(sections, false));
    if (sections.size() > 1 && document()->idealWidth() > viewport()->width()) {
        show_html(*this, html_of(sections, true));
    }
    const bool has_picture = std::ranges::any_of(sections, [](const ExplainedSection& section) {
        return section.picture != ExplainedSection::Picture::none;
    });
    const double over = document()->idealWidth() - viewport()->width();
    if (has_picture && over > 0) {
        picture_room_ -= static_cast<int>(std::ceil(over));
        show_html(*this, html_of(sections, true));
    }
    if (state_.explained().traversal) {
        scrollToAnchor(QStringLiteral("now"));
    }
}

/// Sections that stand beside the longest one go along with it: what a step refers to stays beside
/// the step.
void ExplainedPane::bring_along(int scrolled) {
    const auto frames = document()->rootFrame()->childFrames();
    auto* const table = qobject_cast<QTextTable*>(frames.value(0));
    if (!table || table->columns() < 2) {
        return;
    }
    const auto* const layout = document()->documentLayout();
    const qreal all = layout->frameBoundingRect(table).height();
    for (int column = 0; column < table->columns(); ++column) {
        QTextTableCell cell = table->cellAt(0, column);
        QTextTableCellFormat format = cell.format().toTableCellFormat();
        qreal top = all, bottom = 0;
        for (QTextBlock block = cell.firstCursorPosition().block();
             block.isValid() && block.position() <= cell.lastPosition(); block = block.next()) {
            const QRectF place = layout->blockBoundingRect(block);
            top = std::min(top, place.top());
            bottom = std::max(bottom, place.bottom());
        }
        const qreal room = std::max(0.0, all - (bottom - top) - format.bottomPadding());
        const qreal padding = std::min<qreal>(scrolled, room);
        if (format.topPadding() != padding) {
            format.setTopPadding(padding);
            cell.setFormat(format);
        }
    }
}

QString ExplainedPane::html_of(const std::vector<ExplainedSection>& sections, bool below) {
    const Palette& palette = palette_of(state_.look().theme);
    const QString between = below ? QStringLiteral("</tr><tr>") : QString();
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='0'><tr>");
    for (const ExplainedSection& section : sections) {
        html += QStringLiteral("<td style='padding-right:26px; padding-bottom:9px'>");
        if (section.picture == ExplainedSection::Picture::none) {
            html += inspector::html_of(section, palette);
        } else {
            const QString name = QStringLiteral("picture%1").arg(static_cast<int>(section.picture));
            document()->addResource(QTextDocument::ImageResource, QUrl(name),
                                    picture_of(section.picture));
            html += QStringLiteral(
                        "<table cellspacing='0' cellpadding='0'><tr>"
                        "<td style='padding-right:14px'><img src='%1'/></td><td>%2</td>"
                        "</tr></table>")
                        .arg(name, inspector::html_of(section, palette));
        }
        html += QStringLiteral("</td>") + between;
    }
    return html + QStringLiteral("</tr></table>");
}

/// As large as there is room for beside the numbers, so that it is seen whole.
QImage ExplainedPane::picture_of(ExplainedSection::Picture picture) const {
    constexpr int least = 150, most = 420, margins = 48, numbers = 330;
    const int height = std::clamp(viewport()->height() - margins, least, most);
    const int width = std::clamp(picture_room_ - numbers, least, 2 * most);
    const Palette& palette = palette_of(state_.look().theme);
    switch (picture) {
        case ExplainedSection::Picture::time:
            return time_picture(*state_.explained().time, width, palette);
        case ExplainedSection::Picture::accuracy:
            return accuracy_picture(*state_.explained().accuracy,
                                    {std::min(width, 2 * height), height}, palette);
        default: {
            const Explanation& all = state_.explanation();
            return depth_picture(*all.depth, all.comparison, height, palette);
        }
    }
}

void ExplainedPane::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    if (isVisible() && size() != shown_size_) {  // else a scroll bar has come or gone
        renew();
    }
}

}  // namespace raytree::inspector
