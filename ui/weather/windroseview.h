#pragma once

#include "ui/models/windrose.h"

#include <QWidget>

namespace gorizont {

/// The wind of the last answer.
struct WindNow
{
    std::optional<double> direction; ///< degrees from which it blows
    std::optional<double> speed; ///< m/s
    std::optional<double> meanDirection; ///< degrees
    std::optional<double> meanSpeed; ///< m/s
    std::optional<double> gust; ///< m/s

    /// Of a command that gives no instantaneous values the means are the wind now.
    static WindNow of(const Weather &weather);
    bool operator==(const WindNow &) const = default;
};

/// A compass with the wind of now and, behind it, where it blew from how often and how strongly: a petal a rumb, its length the
/// share of the readings, its parts the classes of speed from the centre outwards, each wider than the one before, so that colour is not
/// alone. The arrow points where the air goes. GUI thread.
class WindRoseView : public QWidget
{
    Q_OBJECT

public:
    explicit WindRoseView(QWidget *parent = nullptr);

    /// \a span is told to those who cannot see the picture.
    void show(const WindCounts &counts, const WindNow &now, const QString &span);
    using QWidget::show;

    /// The share at the rim, of a round size, so that \a largest fits.
    static double rimShare(double largest);
    /// How a class of speed is called: `2 – 4 m/s`.
    static QString className(int speedClass);

    /// One hue, further from a light or a dark background with every class.
    static QColor classColour(int speedClass, bool isDark);

    QSize sizeHint() const override { return {460, 360}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    struct Place ///< of the compass
    {
        QPointF centre;
        double inner = 0; ///< radius of the calm
        double outer = 0; ///< radius of the rim
    };
    Place place() const;
    int legendWidth() const;
    QString description(const QString &span) const;
    void paintCompass(QPainter &painter, const Place &at, double rim) const;
    void paintPetals(QPainter &painter, const Place &at, double rim) const;
    void paintArrows(QPainter &painter, const Place &at) const;
    void paintTexts(QPainter &painter) const;
    void paintLegend(QPainter &painter) const;

    WindCounts m_counts;
    WindNow m_now;
};

} // namespace gorizont
