#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace gorizont::test {

/// Finds and uses the widgets of a service window by their names.
class DialogTester
{
public:
    virtual ~DialogTester() = default;

    template <typename T> T *find(const char *name) const
    {
        T *found = window()->findChild<T *>(QLatin1String(name));
        if (!found) {
            qFatal("no widget %s", name);
        }
        return found;
    }
    QPushButton *button(const char *name) const { return find<QPushButton>(name); }
    QString text(const char *name) const { return find<QLabel>(name)->text(); }

    /// Those that the window offers.
    QList<int> addresses() const
    {
        const auto *combo = find<QComboBox>("addressCombo");
        QList<int> list;
        for (int i = 0; i < combo->count(); ++i) {
            list.append(combo->itemData(i).toInt());
        }
        return list;
    }

    /// As a user chooses, not as a program sets.
    void choose(const char *name, int index) const
    {
        auto *combo = find<QComboBox>(name);
        combo->setCurrentIndex(index);
        Q_EMIT combo->activated(index);
    }

protected:
    virtual QWidget *window() const = 0;
};

} // namespace gorizont::test
