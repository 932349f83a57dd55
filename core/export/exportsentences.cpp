#include "core/export/exportsentences.h"

#include <QCoreApplication>
#include <QDir>

namespace gorizont::exportsentence {

namespace {

struct Export
{
    Q_DECLARE_TR_FUNCTIONS(Export)
};

} // namespace

QString nothingChosen()
{
    return Export::tr("None of the chosen sensors measures a chosen quantity: choose others.");
}

QString noAccelerometer()
{
    return Export::tr("None of the chosen sensors is an accelerometer: miniSEED holds only their samples.");
}

QString emptyRange()
{
    return Export::tr("The range ends before it begins: set another beginning or end.");
}

QString nothingFound()
{
    return Export::tr(
        "There is nothing in this range, and no file was written: choose another range or other sensors.");
}

QString wrongCodes()
{
    return Export::tr("The miniSEED codes are wrong: the network has 1 or 2, the station 1 to 5 and a channel 3 "
                      "capital Latin letters "
                      "or digits, and the two channels differ.");
}

QString noLocation(int number)
{
    return Export::tr("miniSEED has no location code for the sensor %1: give it a number from 1 to 1035.").arg(number);
}

QString sourceGone()
{
    return Export::tr("The archive was closed or could not be read before the export was complete: try again.");
}

QString cannotWrite(const QString &path, const QString &reason)
{
    return Export::tr("%1 cannot be written (%2): make room on the disk, or choose another folder.")
        .arg(QDir::toNativeSeparators(path), reason);
}

} // namespace gorizont::exportsentence
