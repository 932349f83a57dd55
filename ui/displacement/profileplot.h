#pragma once

#include "core/values/displacement.h"

#include <QWidget>

class QCPCurve;
class QCustomPlot;

namespace gorizont {

struct ProfileZero;

/// The shape of a chain in one plane: height over displacement, as it is now and as it was at the zero. GUI thread.
class ProfilePlot : public QWidget
{
    Q_OBJECT

public:
    enum class Plane : quint8 { X, Y };

    explicit ProfilePlot(Plane plane, QWidget *parent = nullptr);

    /// Ends where a sum is missing.
    void show(const std::vector<ChainNode> &nodes, const ProfileZero *zero);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    double part(const Displacement &shift) const { return m_plane == Plane::X ? shift.x : shift.y; }
    void dress();
    void fit(const std::vector<ChainNode> &nodes);

    const Plane m_plane;
    QCustomPlot *m_plot;
    QCPCurve *m_now;
    QCPCurve *m_zero;
};

} // namespace gorizont
