#pragma once

#include <QByteArrayView>
#include <QString>

namespace gorizont::station {

/// CP866, the encoding of DOS. Every byte is a character.
QString decodeCp866(QByteArrayView bytes);

} // namespace gorizont::station
