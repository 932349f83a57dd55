#include "app/opc-da/pure/messages.h"

namespace opcda {

namespace {

struct Sentence
{
    std::uint32_t code;
    TextView english;
    TextView russian;
};

constexpr Sentence Errors[] = {
    {0xC0040001, u"The handle of an item or a group is not valid.", u"Недействительный описатель элемента или группы."},
    {0xC0040004, u"The value cannot be given in the requested data type.",
     u"Значение нельзя представить в запрошенном типе данных."},
    {0xC0040005, u"The operation is not possible for a public group.", u"Действие невозможно для общей группы."},
    {0xC0040006, u"The item can only be read.", u"Элемент доступен только для чтения."},
    {0xC0040007, u"There is no item of this name.", u"Элемента с таким именем нет."},
    {0xC0040008, u"The name of the item is not well formed.", u"Имя элемента записано неправильно."},
    {0xC0040009, u"The filter is not valid.", u"Неправильный фильтр."},
    {0xC004000A, u"The item has no such access path.", u"У элемента нет такого пути доступа."},
    {0xC004000B, u"The value is out of range.", u"Значение вне допустимого диапазона."},
    {0xC004000C, u"The name is taken already.", u"Такое имя уже есть."},
    {0x0004000D, u"The server uses the nearest update rate it supports.",
     u"Сервер использует ближайший возможный период обновления."},
    {0x0004000E, u"The value was accepted and limited.", u"Значение принято с ограничением."},
    {0x0004000F, u"The group is in use and will be removed when it is released.",
     u"Группа используется и будет удалена после освобождения."},
    {0xC0040010, u"The configuration of the server is not valid.", u"Неправильная настройка сервера."},
    {0xC0040011, u"The object was not found.", u"Объект не найден."},
    {0xC0040203, u"The item has no such property.", u"У элемента нет такого свойства."},
    {0xC0040400, u"No deadband was set for the item.", u"Для элемента не задана зона нечувствительности."},
    {0xC0040401, u"The item has no deadband.", u"Элемент не поддерживает зону нечувствительности."},
    {0xC0040402, u"The server does not keep past values.", u"Сервер не хранит прошлые значения."},
    {0xC0040403, u"The continuation point is not valid.", u"Недействительная точка продолжения."},
    {0x00040404, u"Some values were dropped.", u"Часть значений отброшена."},
    {0xC0040405, u"No sampling rate was set for the item.", u"Для элемента не задан период опроса."},
    {0xC0040406, u"The server does not write quality or time.", u"Сервер не записывает качество и время."},
};

constexpr Sentence Properties[] = {
    {1, u"Item Canonical DataType", u"Исходный тип данных"},
    {2, u"Item Value", u"Значение"},
    {3, u"Item Quality", u"Качество"},
    {4, u"Item Timestamp", u"Метка времени"},
    {5, u"Item Access Rights", u"Права доступа"},
    {6, u"Server Scan Rate", u"Период опроса сервером"},
    {7, u"Item EU Type", u"Вид шкалы"},
    {8, u"Item EU Info", u"Сведения о шкале"},
    {100, u"EU Units", u"Единица измерения"},
    {101, u"Item Description", u"Описание"},
    {102, u"High EU", u"Верх шкалы"},
    {103, u"Low EU", u"Низ шкалы"},
};

template <std::size_t N>
std::optional<Text> chosen(const Sentence (&sentences)[N], std::uint32_t code, Language language)
{
    for (const Sentence &sentence : sentences) {
        if (sentence.code == code)
            return Text(language == Language::Russian ? sentence.russian : sentence.english);
    }
    return std::nullopt;
}

} // namespace

std::optional<Text> errorText(std::uint32_t code, Language language)
{
    return chosen(Errors, code, language);
}

Text propertyName(std::uint32_t property, Language language)
{
    return chosen(Properties, property, language).value_or(Text());
}

Text shutdownReason(Language language)
{
    return language == Language::Russian ? u"Программа «Горизонт-сервер» завершает работу"
                                         : u"Gorizont Server is ending";
}

} // namespace opcda
