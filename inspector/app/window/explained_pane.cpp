#include "window/explained_pane.h"

#include <QFontDatabase>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "state/commands.h"
#include "state/explained_text.h"
#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

constexpr int image_side = 190;  // pixels that the depth picture takes at least

/// Near is light, far is dark; where the light sees nothing there is the palette's rule.
QImage image_of(const DepthPicture& picture, const std::optional<DepthComparison>& chosen,
                const Palette& palette) {
    const std::size_t side = chosen ? chosen->place.side : 0;
    const int size = picture.size();
    double near = 1e300, far = 0;
    const auto depth = [&](int i, int j) { return picture.depth({side, i, j}); };
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            if (std::isfinite(depth(i, j))) {
                near = std::min(near, depth(i, j));
                far = std::max(far, depth(i, j));
            }
        }
    }
    QImage image(size, size, QImage::Format_RGB32);
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            const double share =
                far > near ? std::clamp((depth(i, j) - near) / (far - near), 0.0, 1.0) : 0;
            const int grey = static_cast<int>(245 - 190 * share);
            const QColor colour =
                std::isfinite(depth(i, j)) ? QColor(grey, grey, grey) : qt(palette.space_top);
            image.setPixelColor(i, j, colour);
        }
    }
    if (chosen) {
        image.setPixelColor(chosen->place.i, chosen->place.j, qt(palette.selection));
    }
    return image.scaled(std::max(image_side, size), std::max(image_side, size));
}

QString table_of(const ExplainedSection& section, const Palette& palette) {
    const QString dim = qt(palette.dim_text).name();
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='2'>");
    const auto row = [&](const std::vector<std::string>& cells, const QString& style) {
        html += QStringLiteral("<tr>");
        for (const std::string& cell : cells) {
            constexpr std::size_t long_words = 34;
            html += QStringLiteral("<td style='padding-right:16px; %1%2'>%3</td>")
                        .arg(cell.size() > long_words ? QString()
                                                      : QStringLiteral("white-space:nowrap; "),
                             style, qt(cell).toHtmlEscaped());
        }
        html += QStringLiteral("</tr>");
    };
    if (!section.header.empty()) {
        row(section.header, QStringLiteral("color:") + dim);
    }
    for (const ExplainedSection::Row& line : section.rows) {
        row(line.cells, line.strong
                            ? QStringLiteral("font-weight:bold; background-color:%1")
                                  .arg(qt(mixed(palette.panel, palette.accent, 0.12)).name())
                        : line.faint ? QStringLiteral("color:") + dim
                                     : QString());
    }
    return html + QStringLiteral("</table>");
}

QString html_of(const ExplainedSection& section, const Palette& palette) {
    QString html = QStringLiteral("<p style='margin:0 0 3px 0; color:%1'><b>%2</b>")
                       .arg(qt(palette.accent).name(), qt(section.title).toHtmlEscaped());
    for (const ExplainedSection::Link& link : section.links) {
        html += QStringLiteral("&nbsp;&nbsp; <a href='%1' style='color:%2'>%3</a>")
                    .arg(qt(link.command), qt(palette.accent).name(), qt(link.words));
    }
    html += QStringLiteral("</p>") + table_of(section, palette);
    for (const std::string& sentence : section.sentences) {
        html += QStringLiteral("<p style='margin:3px 0 3px 0; color:%1'>%2</p>")
                    .arg(qt(palette.dim_text).name(), qt(sentence).toHtmlEscaped());
    }
    return html;
}

}  // namespace

ExplainedPane::ExplainedPane(State& state, QWidget* parent) : QTextBrowser(parent), state_(state) {
    setOpenLinks(false);
    document()->setDocumentMargin(10);
    connect(this, &QTextBrowser::anchorClicked, this,
            [this](const QUrl& to) { run_command(state_, to.path().toStdString()); });
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
    shown_width_ = width();
    const Palette& palette = palette_of(state_.look().theme);
    const auto sections = explained_text(state_);
    if (sections.empty()) {
        setHtml(
            QStringLiteral("<p style='color:%1'>The menu <b>Explain</b> shows here the lecture's "
                           "ways of explaining what a ray does: rays sent from a light, the way "
                           "through a hierarchy, shadow volumes, a light's depth picture, the "
                           "z-buffer.</p>")
                .arg(qt(palette.dim_text).name()));
        return;
    }
    // Beside each other where there is room, else below each other.
    setHtml(html_of(sections, false));
    if (document()->idealWidth() > viewport()->width()) {
        setHtml(html_of(sections, true));
    }
}

QString ExplainedPane::html_of(const std::vector<ExplainedSection>& sections, bool below) {
    const Palette& palette = palette_of(state_.look().theme);
    const QString between = below ? QStringLiteral("</tr><tr>") : QString();
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='0'><tr>");
    for (const ExplainedSection& section : sections) {
        html += QStringLiteral("<td style='padding-right:26px; padding-bottom:9px'>");
        if (section.depth) {
            document()->addResource(
                QTextDocument::ImageResource, QUrl(QStringLiteral("depth")),
                image_of(*state_.explanation().depth, state_.explanation().comparison, palette));
            html += QStringLiteral(
                        "<table cellspacing='0' cellpadding='0'><tr>"
                        "<td style='padding-right:14px'><img src='depth'/></td><td>%1</td>"
                        "</tr></table>")
                        .arg(inspector::html_of(section, palette));
        } else {
            html += inspector::html_of(section, palette);
        }
        html += QStringLiteral("</td>") + between;
    }
    return html + QStringLiteral("</tr></table>");
}

void ExplainedPane::resizeEvent(QResizeEvent* event) {
    QTextBrowser::resizeEvent(event);
    if (isVisible() && width() != shown_width_) {  // else a scroll bar has come or gone
        renew();
    }
}

}  // namespace raytree::inspector
