#pragma once

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace gorizont {

/// The control word of a station's outputs as 32 boxes and as a number, both the same. GUI thread.
class Mk14OutputsPanel : public QWidget
{
    Q_OBJECT

public:
    static constexpr int count = 32;

    explicit Mk14OutputsPanel(QWidget *parent = nullptr);

    /// The word that is in force; empty: not known.
    void showWord(std::optional<quint32> word);
    std::optional<quint32> shownWord() const { return m_shown; }
    quint32 word() const; ///< as it stands in the boxes
    bool isEdited() const
    {
        return m_shown && (m_problem || word() != *m_shown);
    } ///< the boxes or the number differ from what is in force
    void setControls(bool isShown);

    QWidgetList tabOrder() const;

    /// `0x1F`, `31`; empty: no word of 32 bits.
    static std::optional<quint32> typedWord(const QString &text);

Q_SIGNALS:
    void edited();
    void setWanted();

private:
    QWidget *makeBoxes();
    void setBoxes(quint32 word);
    void writeNumber();
    void takeNumber(const QString &text);

    std::array<QCheckBox *, count> m_boxes{};
    QLineEdit *m_number;
    QLabel *m_inForce;
    QPushButton *m_set;
    std::optional<quint32> m_shown;
    bool m_problem = false; ///< what is typed is no word
    bool m_isFilling = false; ///< it is we who change the boxes
};

} // namespace gorizont
