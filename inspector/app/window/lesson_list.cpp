#include "window/lesson_list.h"

#include "window/qt_text.h"

namespace raytree::inspector {
namespace {

QString joined(const std::vector<std::string>& words) {
    QString text;
    for (const std::string& word : words) {
        text += (text.isEmpty() ? QString() : QStringLiteral("; ")) + qt(word).toHtmlEscaped();
    }
    return text;
}

/// "04-spheres" as "4".
QString number_of(const std::string& name) {
    QString number = qt(name).section(QLatin1Char('-'), 0, 0);
    while (number.startsWith(QLatin1Char('0'))) {
        number.remove(0, 1);
    }
    return number;
}

}  // namespace

QString list_html(const std::vector<LessonEntry>& entries, const std::string& open,
                  const Palette& palette) {
    const QString dim = qt(palette.dim_text).name();
    QString html = QStringLiteral(
                       "<p style='font-size:large; margin:0 0 2px 0'><b>Lessons</b></p>"
                       "<p style='color:%1; margin:0 0 6px 0'>Choose one; they build on "
                       "each other, in this order.</p>")
                       .arg(dim);
    for (const LessonEntry& entry : entries) {
        html += QStringLiteral(
                    "<p style='margin:9px 0 0 0'><span style='color:%1'>%2.</span>&nbsp; "
                    "<a href='%3' style='color:%4; text-decoration:none'><b>%5</b></a>%6</p>")
                    .arg(dim, number_of(entry.name), qt(entry.name), qt(palette.accent).name(),
                         qt(entry.title).toHtmlEscaped(),
                         entry.name == open ? QStringLiteral("&nbsp; ◂ open") : QString());
        if (!entry.failure.empty()) {
            html += QStringLiteral("<p style='margin:0 0 0 16px'>✗ cannot be read: %1</p>")
                        .arg(qt(entry.failure).toHtmlEscaped());
            continue;
        }
        html += QStringLiteral("<p style='margin:0 0 0 16px; color:%1'>%2 · %3 steps, %4 minutes")
                    .arg(dim, qt(entry.topic).toHtmlEscaped())
                    .arg(entry.steps)
                    .arg(entry.minutes);
        if (!entry.before.empty()) {
            html += QStringLiteral("<br>Before: ") + joined(entry.before);
        }
        html += QStringLiteral("</p>");
    }
    return html;
}

}  // namespace raytree::inspector
