<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>About</source>
        <translation>О программе</translation>
    </message>
    <message>
        <source>Watches buildings: polls inclinometers and accelerometers, shows, saves and serves their readings.</source>
        <translation>Наблюдает за зданиями: опрашивает инклинометры и акселерометры, показывает, сохраняет и передаёт их показания.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3. It comes without any warranty.</source>
        <translation>Свободная программа под лицензией GNU General Public License версии 3. Распространяется без каких-либо гарантий.</translation>
    </message>
    <message>
        <source>Built with Qt %1</source>
        <translation>Используется Qt %1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
</context>
<context>
    <name>AlarmText</name>
    <message>
        <source>The port cannot be opened</source>
        <translation>Порт не открывается</translation>
    </message>
    <message>
        <source>The connection to the port is lost</source>
        <translation>Связь с портом потеряна</translation>
    </message>
    <message>
        <source>Switch the port on in the configuration file.</source>
        <translation>Включите порт в файле настроек.</translation>
    </message>
    <message>
        <source>Check that the adapter is plugged in and powered, and the number of the port.</source>
        <translation>Проверьте, что адаптер подключён и включён, и верен ли номер порта.</translation>
    </message>
    <message>
        <source>Check the adapter, its cable and its power. The program opens the port again by itself.</source>
        <translation>Проверьте адаптер, его кабель и питание. Программа откроет порт снова сама.</translation>
    </message>
    <message>
        <source>%1; sensors without data: %2</source>
        <translation>%1; датчиков без данных: %2</translation>
    </message>
    <message>
        <source>Check the power of the sensor, its cable and its address.</source>
        <translation>Проверьте питание датчика, кабель и адрес.</translation>
    </message>
    <message>
        <source>Check the terminating resistor and the cable for interference, and that no two sensors have the same address.</source>
        <translation>Проверьте согласующий резистор и помехи на кабеле, а также нет ли двух датчиков с одним адресом.</translation>
    </message>
    <message>
        <source>Check the supply voltage and the cable of the transducer, restart the sensor. If that does not help, it needs repair.</source>
        <translation>Проверьте напряжение питания и кабель преобразователя, перезапустите датчик. Если не помогло, нужен ремонт.</translation>
    </message>
    <message>
        <source>Restart the sensor. If that does not help, it needs repair.</source>
        <translation>Перезапустите датчик. Если не помогло, нужен ремонт.</translation>
    </message>
    <message>
        <source>Look at the structure and at how the sensor is fixed: it is inclined or moves beyond what it can measure.</source>
        <translation>Осмотрите конструкцию и крепление датчика: наклон или движение выходит за диапазон измерений.</translation>
    </message>
    <message>
        <source>The sensor goes on without a temperature. Plan its repair.</source>
        <translation>Датчик работает без температуры. Запланируйте ремонт.</translation>
    </message>
    <message>
        <source>Check the temperature at the sensor. If it is usual, the sensor needs repair.</source>
        <translation>Проверьте температуру у датчика. Если она обычная, датчику нужен ремонт.</translation>
    </message>
    <message>
        <source>Check the fan of the thermostat: dirt, ice, its cable. The readings may drift.</source>
        <translation>Проверьте вентилятор термостата: грязь, лёд, провод. Показания могут уходить.</translation>
    </message>
    <message>
        <source>Check the heating and the cover of the sensor: it may be too cold there. The readings may drift.</source>
        <translation>Проверьте подогрев и крышку датчика: возможно, ему слишком холодно. Показания могут уходить.</translation>
    </message>
    <message>
        <source>Look at the status word of the sensor.</source>
        <translation>Посмотрите слово состояния датчика.</translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s) need attention</source>
        <translation>
            <numerusform>%n датчик требует внимания</numerusform>
            <numerusform>%n датчика требуют внимания</numerusform>
            <numerusform>%n датчиков требуют внимания</numerusform>
        </translation>
    </message>
    <message>
        <source>and more: %1</source>
        <translation>и ещё: %1</translation>
    </message>
    <message>
        <source>Check the cable and the connectors from the module to the sensors of these channels. A channel without a sensor can be switched off in the settings of the module.</source>
        <translation>Проверьте кабель и разъёмы от модуля до датчиков этих каналов. Канал без датчика можно отключить в настройках модуля.</translation>
    </message>
    <message>
        <source>Check the power supply of the weather station: none of its values is good without it.</source>
        <translation>Проверьте питание метеостанции: без него все её значения негодны.</translation>
    </message>
</context>
<context>
    <name>And3Driver</name>
    <message>
        <source>The sensor has restarted.</source>
        <translation>Датчик перезагрузился.</translation>
    </message>
    <message>
        <source>The sensor counts its measurements anew.</source>
        <translation>Датчик начал отсчёт измерений заново.</translation>
    </message>
    <message>
        <source>The buffer of accelerations overran, packets lost: %1.</source>
        <translation>Переполнен буфер ускорений, потеряно пакетов: %1.</translation>
    </message>
    <message>
        <source>The recording of accelerations was stopped; it is started again.</source>
        <translation>Запись ускорений была остановлена; она запущена снова.</translation>
    </message>
    <message>
        <source>Packets of accelerations do not follow each other.</source>
        <translation>Пакеты ускорений не следуют друг за другом.</translation>
    </message>
    <message>
        <source>Firmware %1.</source>
        <translation>Версия ПО %1.</translation>
    </message>
</context>
<context>
    <name>AppendFile</name>
    <message>
        <source>the folder %1 cannot be created</source>
        <translation>не удаётся создать папку %1</translation>
    </message>
</context>
<context>
    <name>CapturePlan</name>
    <message>
        <source>%1%2: &quot;%3&quot; is not understood; it takes %4. Its usual value is used.</source>
        <translation>%1%2: непонятно «%3»; допустимо %4. Используется обычное значение.</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>Time</source>
        <translation>Время</translation>
    </message>
    <message>
        <source>min</source>
        <translation>мин.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>средн.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>макс.</translation>
    </message>
    <message>
        <source>Tilt X</source>
        <translation>Наклон X</translation>
    </message>
    <message>
        <source>Tilt Y</source>
        <translation>Наклон Y</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Температура</translation>
    </message>
    <message>
        <source>Heater power</source>
        <translation>Мощность подогревателя</translation>
    </message>
    <message>
        <source>Fan frequency</source>
        <translation>Частота вентилятора</translation>
    </message>
    <message>
        <source>Maximum acceleration</source>
        <translation>Максимальное ускорение</translation>
    </message>
    <message>
        <source>Maximum acceleration, X</source>
        <translation>Максимальное ускорение, X</translation>
    </message>
    <message>
        <source>Maximum acceleration, Y</source>
        <translation>Максимальное ускорение, Y</translation>
    </message>
    <message>
        <source>RMS acceleration</source>
        <translation>СКЗ ускорения</translation>
    </message>
    <message>
        <source>RMS acceleration, X</source>
        <translation>СКЗ ускорения, X</translation>
    </message>
    <message>
        <source>RMS acceleration, Y</source>
        <translation>СКЗ ускорения, Y</translation>
    </message>
    <message>
        <source>Direction of the maximum</source>
        <translation>Направление максимума</translation>
    </message>
    <message>
        <source>Acceleration X</source>
        <translation>Ускорение X</translation>
    </message>
    <message>
        <source>Acceleration Y</source>
        <translation>Ускорение Y</translation>
    </message>
    <message>
        <source>arc-seconds</source>
        <translation>угл. сек.</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>1/s</source>
        <translation>об/с</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>град.</translation>
    </message>
    <message>
        <source>mm/s²</source>
        <translation>мм/с²</translation>
    </message>
    <message>
        <source>None of the chosen sensors measures a chosen quantity: choose others.</source>
        <translation>Ни один из выбранных датчиков не измеряет ни одной из выбранных величин: выберите другие.</translation>
    </message>
    <message>
        <source>None of the chosen sensors is an accelerometer: miniSEED holds only their samples.</source>
        <translation>Среди выбранных датчиков нет акселерометров: формат miniSEED хранит только их отсчёты.</translation>
    </message>
    <message>
        <source>The range ends before it begins: set another beginning or end.</source>
        <translation>Конец промежутка раньше его начала: задайте другое начало или другой конец.</translation>
    </message>
    <message>
        <source>There is nothing in this range, and no file was written: choose another range or other sensors.</source>
        <translation>За это время данных нет, файл не записан: выберите другой промежуток или другие датчики.</translation>
    </message>
    <message>
        <source>The miniSEED codes are wrong: the network has 1 or 2, the station 1 to 5 and a channel 3 capital Latin letters or digits, and the two channels differ.</source>
        <translation>Неверные коды miniSEED: код сети — 1–2, станции — от 1 до 5, канала — 3 заглавные латинские буквы или цифры, и коды каналов различны.</translation>
    </message>
    <message>
        <source>miniSEED has no location code for the sensor %1: give it a number from 1 to 1035.</source>
        <translation>В miniSEED нет кода положения для датчика %1: присвойте ему номер от 1 до 1035.</translation>
    </message>
    <message>
        <source>The archive was closed or could not be read before the export was complete: try again.</source>
        <translation>Архив закрыт или не прочитан, экспорт не закончен: повторите попытку.</translation>
    </message>
    <message>
        <source>%1 cannot be written (%2): make room on the disk, or choose another folder.</source>
        <translation>Не удаётся записать %1 (%2): освободите место на диске или выберите другую папку.</translation>
    </message>
    <message>
        <source>The samples are in raw units of the device, along its own axes: neither turned nor inverted.
Acceleration, mm/s² = sample × scale.</source>
        <translation>Отсчёты — в единицах прибора, по его собственным осям: без поворота и без инверсии.
Ускорение, мм/с² = отсчёт × масштаб.</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Канал</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Датчик</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Ось</translation>
    </message>
    <message>
        <source>Samples a second</source>
        <translation>Отсчётов в секунду</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Масштаб</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>С момента</translation>
    </message>
    <message>
        <source>Displacement X</source>
        <translation>Перемещение X</translation>
    </message>
    <message>
        <source>Displacement Y</source>
        <translation>Перемещение Y</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>Wind speed</source>
        <translation>Скорость ветра</translation>
    </message>
    <message>
        <source>Wind direction</source>
        <translation>Направление ветра</translation>
    </message>
    <message>
        <source>Maximum wind speed</source>
        <translation>Максимальная скорость ветра</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Давление</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Влажность</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>м/с</translation>
    </message>
    <message>
        <source>mm Hg</source>
        <translation>мм рт. ст.</translation>
    </message>
</context>
<context>
    <name>GatewayRegistration</name>
    <message>
        <source>%1 is missing. Install the program with its OPC DA part.</source>
        <translation>Нет файла %1. Установите программу вместе с частью OPC DA.</translation>
    </message>
    <message>
        <source>Windows has refused it (error %1). Start the program once as administrator.</source>
        <translation>Windows отказала (ошибка %1). Запустите программу один раз от имени администратора.</translation>
    </message>
    <message>
        <source>The gateway does not start (%1).</source>
        <translation>Шлюз не запускается (%1).</translation>
    </message>
</context>
<context>
    <name>Ind3Driver</name>
    <message>
        <source>The protocol &quot;%1&quot; is not known; 2.11 is used</source>
        <translation>Протокол «%1» неизвестен; используется 2.11</translation>
    </message>
</context>
<context>
    <name>LVims</name>
    <message>
        <source>not used</source>
        <translation>не используется</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>виброускорение</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>виброскорость</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>виброперемещение</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>зазор</translation>
    </message>
    <message>
        <source>speed of rotation</source>
        <translation>частота вращения</translation>
    </message>
    <message>
        <source>amplitude of a harmonic of acceleration</source>
        <translation>амплитуда гармоники виброускорения</translation>
    </message>
    <message>
        <source>phase of a harmonic of acceleration</source>
        <translation>фаза гармоники виброускорения</translation>
    </message>
    <message>
        <source>amplitude of a harmonic of velocity</source>
        <translation>амплитуда гармоники виброскорости</translation>
    </message>
    <message>
        <source>phase of a harmonic of velocity</source>
        <translation>фаза гармоники виброскорости</translation>
    </message>
    <message>
        <source>amplitude of a harmonic of displacement</source>
        <translation>амплитуда гармоники виброперемещения</translation>
    </message>
    <message>
        <source>phase of a harmonic of displacement</source>
        <translation>фаза гармоники виброперемещения</translation>
    </message>
    <message>
        <source>constant part of acceleration</source>
        <translation>постоянная составляющая ускорения</translation>
    </message>
    <message>
        <source>RMS of a harmonic of acceleration</source>
        <translation>СКЗ гармоники виброускорения</translation>
    </message>
    <message>
        <source>RMS of a harmonic of velocity</source>
        <translation>СКЗ гармоники виброскорости</translation>
    </message>
    <message>
        <source>RMS of a harmonic of displacement</source>
        <translation>СКЗ гармоники виброперемещения</translation>
    </message>
    <message>
        <source>largest deviation of the shaft from its mean</source>
        <translation>наибольшее отклонение вала от среднего положения</translation>
    </message>
    <message>
        <source>mm/s²</source>
        <translation>мм/с²</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>мм/с</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>мкм</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>об/мин</translation>
    </message>
    <message>
        <source>MeasUnit%1: &quot;%2&quot; is not understood. It takes a unit for the accelerations, or TYPE:UNIT with a type 1…16; the usual unit stays.</source>
        <translation>MeasUnit%1: непонятно «%2». Допустима единица для всех виброускорений или ТИП:ЕДИНИЦА с типом 1…16; остаётся обычная единица.</translation>
    </message>
    <message>
        <source>good</source>
        <translation>исправен</translation>
    </message>
    <message>
        <source>the line of the sensor is shorted</source>
        <translation>замыкание линии датчика</translation>
    </message>
    <message>
        <source>the line of the sensor is broken</source>
        <translation>обрыв линии датчика</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>нет данных</translation>
    </message>
    <message>
        <source>state %1</source>
        <translation>состояние %1</translation>
    </message>
    <message>
        <source>off</source>
        <translation>отключён</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>неисправность</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>предупреждение</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>останов</translation>
    </message>
    <message>
        <source>far from its usual value</source>
        <translation>далеко от обычного значения</translation>
    </message>
    <message>
        <source>Line of the sensor shorted: channel %1</source>
        <translation>Замыкание линии датчика: канал %1</translation>
    </message>
    <message>
        <source>Line of the sensor broken: channel %1</source>
        <translation>Обрыв линии датчика: канал %1</translation>
    </message>
    <message>
        <source>line of the sensor broken: channel %1</source>
        <translation>обрыв линии датчика: канал %1</translation>
    </message>
</context>
<context>
    <name>LVimsDriver</name>
    <message>
        <source>The module refuses to be read (exception %1 of Modbus). Check the keys Unit and ReadFunction of the sensor.</source>
        <translation>Модуль отказывается отвечать на чтение (исключение Modbus %1). Проверьте ключи Unit и ReadFunction датчика.</translation>
    </message>
    <message>
        <source>The module is in its boot loader and measures nothing. Restart it, or load its program.</source>
        <translation>Модуль находится в загрузчике и не измеряет. Перезапустите его или загрузите в него программу.</translation>
    </message>
    <message>
        <source>Channel %1: the line of the sensor is shorted. Check its cable.</source>
        <translation>Канал %1: короткое замыкание линии датчика. Проверьте кабель.</translation>
    </message>
    <message>
        <source>Channel %1: the line of the sensor is broken. Check its cable.</source>
        <translation>Канал %1: обрыв линии датчика. Проверьте кабель.</translation>
    </message>
    <message>
        <source>Channel %1: the sensor works again.</source>
        <translation>Канал %1: датчик снова работает.</translation>
    </message>
    <message>
        <source>%1%2 is &quot;%3&quot;, but takes %4…%5. Its usual value is used.</source>
        <translation>%1%2 равен «%3», а допустимо %4…%5. Принято обычное значение.</translation>
    </message>
    <message>
        <source>The waveform of channel %1</source>
        <translation>Выборка канала %1</translation>
    </message>
    <message>
        <source>The spectrum of channel %1 up to 5000 Hz</source>
        <translation>Спектр канала %1 до 5000 Гц</translation>
    </message>
    <message>
        <source>The spectrum of channel %1 up to 200 Hz</source>
        <translation>Спектр канала %1 до 200 Гц</translation>
    </message>
    <message>
        <source>the module refuses it. It is tried again at the next time.</source>
        <translation>модуль отказывает. Следующая попытка — в очередной срок.</translation>
    </message>
    <message>
        <source>another client of the module disturbed it. It is tried again at the next time.</source>
        <translation>помешал другой клиент модуля. Следующая попытка — в очередной срок.</translation>
    </message>
    <message>
        <source>the module did not finish it in time. It is tried again at the next time.</source>
        <translation>модуль не успел закончить. Следующая попытка — в очередной срок.</translation>
    </message>
    <message>
        <source>%1 cannot be captured: %2</source>
        <translation>%1 — захват не удался: %2</translation>
    </message>
    <message>
        <source>%1 is captured again.</source>
        <translation>%1 — захват снова удаётся.</translation>
    </message>
</context>
<context>
    <name>LVimsSettings</name>
    <message>
        <source>an IPv4 address of one machine, such as 192.168.1.10</source>
        <translation>адрес IPv4 одного устройства, например 192.168.1.10</translation>
    </message>
    <message>
        <source>a mask of a network, such as 255.255.255.0</source>
        <translation>маску сети, например 255.255.255.0</translation>
    </message>
    <message>
        <source>an IPv4 address, or 0.0.0.0 for none</source>
        <translation>адрес IPv4 или 0.0.0.0, если шлюза нет</translation>
    </message>
    <message>
        <source>a sum of 1, 2, 4, 8 for channels 0…3, or 0</source>
        <translation>сумму чисел 1, 2, 4, 8 для каналов 0…3 или 0</translation>
    </message>
    <message>
        <source>a whole number of ms, %1…%2</source>
        <translation>целое число мс, %1…%2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>число</translation>
    </message>
    <message>
        <source>a type of measurement, 0…%1</source>
        <translation>тип измерения, 0…%1</translation>
    </message>
    <message>
        <source>0 or 1</source>
        <translation>0 или 1</translation>
    </message>
    <message>
        <source>a frequency in Hz, not below 0, in steps of 0.1</source>
        <translation>частоту в Гц, не меньше 0, с шагом 0.1</translation>
    </message>
    <message>
        <source>%1 takes %2, not &quot;%3&quot;.</source>
        <translation>%1 принимает %2, а не «%3».</translation>
    </message>
</context>
<context>
    <name>Metrics</name>
    <message>
        <source>Another program uses this port. Stop that program or choose another Port in [Metrics].</source>
        <translation>Этот порт занят другой программой. Закройте её или выберите другой Port в [Metrics].</translation>
    </message>
    <message>
        <source>Ports below 1024 need a right. Choose another Port in [Metrics].</source>
        <translation>Для портов ниже 1024 нужно особое право. Выберите другой Port в [Metrics].</translation>
    </message>
    <message>
        <source>This computer does not have the address given in Bind of [Metrics].</source>
        <translation>У этого компьютера нет адреса, указанного в Bind секции [Metrics].</translation>
    </message>
    <message>
        <source>Check Port and Bind in [Metrics].</source>
        <translation>Проверьте Port и Bind в [Metrics].</translation>
    </message>
    <message>
        <source>Metrics: &quot;%1&quot; in Bind of [Metrics] is not an IP address. Not serving until it is corrected.</source>
        <translation>Метрики: «%1» в Bind секции [Metrics] — не IP-адрес. Сервер не работает, пока это не исправлено.</translation>
    </message>
    <message>
        <source>Metrics: serving http://%1:%2/metrics.</source>
        <translation>Метрики: доступны по адресу http://%1:%2/metrics.</translation>
    </message>
    <message>
        <source>Metrics: cannot serve on port %1 (%2). %3 Trying again every %4 s.</source>
        <translation>Метрики: порт %1 открыть не удалось (%2). %3 Попытки повторяются каждые %4 с.</translation>
    </message>
</context>
<context>
    <name>Mk14Driver</name>
    <message>
        <source>The station has data again.</source>
        <translation>У станции снова есть данные.</translation>
    </message>
    <message>
        <source>The station answers, but has no data. It may just have been switched on.</source>
        <translation>Станция отвечает, но данных у неё нет. Возможно, она только что включена.</translation>
    </message>
    <message>
        <source>The station sends %1 parameters, but %2 are listed. Its values are named by their place. Make Params%3 or ParFile%3 agree with the station&apos;s ACK.PAR.</source>
        <translation>Станция передаёт параметров: %1, а перечислено: %2. Величины названы по месту. Приведите Params%3 или ParFile%3 в соответствие с ACK.PAR станции.</translation>
    </message>
    <message>
        <source>The station does not answer CMD %1, but others it does. Leave it out in Cmd%2.</source>
        <translation>На команду %1 станция не отвечает, на другие отвечает. Исключите её в ключе Cmd%2.</translation>
    </message>
    <message>
        <source>%1%2 is &quot;%3&quot;, but takes %4. Its usual value is used.</source>
        <translation>%1%2 задан как «%3», а допустимо: %4. Взято обычное значение.</translation>
    </message>
    <message>
        <source>numbers from 1 to 8, like 8,4</source>
        <translation>числа от 1 до 8, например 8,4</translation>
    </message>
    <message>
        <source>a number of at most 32 bits, like 5 or 0x0005</source>
        <translation>число не длиннее 32 бит, например 5 или 0x0005</translation>
    </message>
    <message>
        <source>letters, like U,T,P,H,A,M</source>
        <translation>буквы, например U,T,P,H,A,M</translation>
    </message>
    <message>
        <source>ParFile%1: %2: %3. Params%1 is used.</source>
        <translation>ParFile%1: %2: %3. Действует Params%1.</translation>
    </message>
    <message>
        <source>ParFile%1: %2, line %3: name, unit, short name, code (a letter) and number are expected. The line is left out.</source>
        <translation>ParFile%1: %2, строка %3: нужны наименование, единицы, условное имя, код (буква) и номер. Строка пропущена.</translation>
    </message>
    <message>
        <source>ParFile%1: %2 has no parameter. Params%1 is used.</source>
        <translation>ParFile%1: в %2 нет ни одного параметра. Действует Params%1.</translation>
    </message>
</context>
<context>
    <name>Mk14Parameters</name>
    <message>
        <source>Supply voltage</source>
        <translation>Напряжение питания</translation>
    </message>
    <message>
        <source>V</source>
        <translation>В</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Температура</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Давление</translation>
    </message>
    <message>
        <source>mm Hg</source>
        <translation>мм рт. ст.</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Влажность</translation>
    </message>
    <message>
        <source>Wind direction</source>
        <translation>Направление ветра</translation>
    </message>
    <message>
        <source>Wind speed</source>
        <translation>Скорость ветра</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>м/с</translation>
    </message>
    <message>
        <source>Wind speed, mean vector</source>
        <translation>Скорость ветра по составляющим</translation>
    </message>
</context>
<context>
    <name>Modbus</name>
    <message>
        <source>Modbus TCP: %1 sensors, the first of them N=%2, find no room below register 65536 in unit %3 and are not served there.</source>
        <translation>Modbus TCP: датчикам (%1 шт., первый из них N=%2) не хватает места ниже регистра 65536 в устройстве %3, там они не передаются.</translation>
    </message>
</context>
<context>
    <name>Mqtt</name>
    <message>
        <source>MQTT: no address is known for %1 (%2). Check Host in [MQTT] and the name server.</source>
        <translation>MQTT: для узла %1 не найден адрес (%2). Проверьте Host в [MQTT] и сервер имён.</translation>
    </message>
    <message>
        <source>MQTT: the broker %1 cannot be reached (%2). Check Host, Port and TLS in [MQTT], and the network.</source>
        <translation>MQTT: брокер %1 недоступен (%2). Проверьте Host, Port и TLS в [MQTT], а также сеть.</translation>
    </message>
    <message>
        <source>MQTT: the broker %1 does not answer. Check Host, Port and TLS in [MQTT], and the network.</source>
        <translation>MQTT: брокер %1 не отвечает. Проверьте Host, Port и TLS в [MQTT], а также сеть.</translation>
    </message>
    <message>
        <source>MQTT: a file named in [MQTT] cannot be read: %1. Check its name and its rights.</source>
        <translation>MQTT: файл, указанный в [MQTT], не читается: %1. Проверьте его имя и права доступа.</translation>
    </message>
    <message>
        <source>MQTT: no encrypted connection to the broker %1 (%2). Check Port and the certificates in [MQTT].</source>
        <translation>MQTT: защищённое соединение с брокером %1 не установлено (%2). Проверьте Port и сертификаты в [MQTT].</translation>
    </message>
    <message>
        <source>MQTT: the certificate of the broker %1 is not trusted (%2). CAFile in [MQTT] has to hold who signed it, Host the name it is for.</source>
        <translation>MQTT: сертификату брокера %1 нет доверия (%2). В [MQTT] ключ CAFile должен указывать сертификат того, кто его подписал, а Host — имя, на которое он выдан.</translation>
    </message>
    <message>
        <source>MQTT: the broker %1 does not accept user and password. Check User and PasswordFile in [MQTT].</source>
        <translation>MQTT: брокер %1 не принимает имя пользователя и пароль. Проверьте User и PasswordFile в [MQTT].</translation>
    </message>
    <message>
        <source>MQTT: the broker %1 lets nobody in as this user. Check User and PasswordFile in [MQTT], and the rights given in the broker.</source>
        <translation>MQTT: брокер %1 не допускает этого пользователя. Проверьте User и PasswordFile в [MQTT] и права, заданные в брокере.</translation>
    </message>
    <message>
        <source>MQTT: the broker %1 rejects the connection (%2).</source>
        <translation>MQTT: брокер %1 отклоняет соединение (%2).</translation>
    </message>
    <message>
        <source>MQTT: the connection to the broker %1 is lost (%2).</source>
        <translation>MQTT: соединение с брокером %1 потеряно (%2).</translation>
    </message>
    <message>
        <source>MQTT: connected to the broker %1.</source>
        <translation>MQTT: соединение с брокером %1 установлено.</translation>
    </message>
    <message>
        <source>Readings that wait and are sent first: %1.</source>
        <translation>Сначала передаются накопленные измерения: %1.</translation>
    </message>
    <message>
        <source>Readings are kept on the disk until they can be sent.</source>
        <translation>Измерения накапливаются на диске, пока их нельзя передать.</translation>
    </message>
    <message>
        <source>MQTT: disk or name server were busy for too long, readings that were not kept: %1.</source>
        <translation>MQTT: диск или сервер имён слишком долго были заняты, не сохранено измерений: %1.</translation>
    </message>
</context>
<context>
    <name>OpcSentences</name>
    <message>
        <source>OPC DA: gateways of this computer are fed on port %1.</source>
        <translation>OPC DA: шлюзы этого компьютера получают данные на порту %1.</translation>
    </message>
    <message>
        <source>OPC DA needs Windows; here only the feed for a gateway gorizont-opc-da works, on port %1 of this computer.</source>
        <translation>Для OPC DA нужна Windows; здесь работает только поток данных для шлюза gorizont-opc-da, на порту %1 этого компьютера.</translation>
    </message>
    <message>
        <source>OPC DA: a gateway was refused, %1 are connected already. One gateway serves any number of OPC clients; end those that are not needed.</source>
        <translation>OPC DA: шлюзу отказано, уже подключено %1. Один шлюз обслуживает любое число клиентов OPC; завершите лишние.</translation>
    </message>
    <message>
        <source>OPC DA: a client was disconnected, it is no gateway of this program (a line of more than 4096 bytes). Look what else uses the port given by [OPC] Port.</source>
        <translation>OPC DA: клиент отключён, это не шлюз этой программы (строка длиннее 4096 байт). Проверьте, что ещё обращается к порту, заданному в [OPC] Port.</translation>
    </message>
    <message>
        <source>OPC DA: a gateway was disconnected, it takes nothing any more. It connects again by itself; if not, end gorizont-opc-da in the task manager.</source>
        <translation>OPC DA: шлюз отключён, он больше не принимает данные. Он подключится снова сам; если нет, завершите gorizont-opc-da в диспетчере задач.</translation>
    </message>
    <message>
        <source>OPC DA: the gateway was registered with another list of tags. Start the program once as administrator, and let the SCADA system read the list of tags anew.</source>
        <translation>OPC DA: шлюз зарегистрирован с другим списком тэгов. Запустите программу один раз от имени администратора и заново прочитайте список тэгов в системе SCADA.</translation>
    </message>
</context>
<context>
    <name>OpcTags</name>
    <message>
        <source>the restart was acknowledged</source>
        <translation>перезагрузка подтверждена</translation>
    </message>
    <message>
        <source>angles are ready</source>
        <translation>углы готовы</translation>
    </message>
    <message>
        <source>temperature is ready</source>
        <translation>температура готова</translation>
    </message>
    <message>
        <source>the transducer does not answer</source>
        <translation>первичный преобразователь не отвечает</translation>
    </message>
    <message>
        <source>CRC errors of the transducer</source>
        <translation>ошибки CRC первичного преобразователя</translation>
    </message>
    <message>
        <source>the transducer is out of range</source>
        <translation>первичный преобразователь вне диапазона</translation>
    </message>
    <message>
        <source>temperature cannot be read</source>
        <translation>температура не читается</translation>
    </message>
    <message>
        <source>temperature is out of range</source>
        <translation>температура вне диапазона</translation>
    </message>
    <message>
        <source>temperature, °C</source>
        <translation>температура, °C</translation>
    </message>
    <message>
        <source>reserve</source>
        <translation>резерв</translation>
    </message>
    <message>
        <source>packets of accelerations read since the start</source>
        <translation>прочитано пакетов ускорений с начала работы</translation>
    </message>
    <message>
        <source>angle X, arc-seconds</source>
        <translation>угол X, угл. сек.</translation>
    </message>
    <message>
        <source>angle Y, arc-seconds</source>
        <translation>угол Y, угл. сек.</translation>
    </message>
    <message>
        <source>largest acceleration, X, mm/s²</source>
        <translation>максимальное ускорение, X, мм/с²</translation>
    </message>
    <message>
        <source>largest acceleration, Y, mm/s²</source>
        <translation>максимальное ускорение, Y, мм/с²</translation>
    </message>
    <message>
        <source>RMS of acceleration, X, mm/s²</source>
        <translation>СКО ускорения, X, мм/с²</translation>
    </message>
    <message>
        <source>RMS of acceleration, Y, mm/s²</source>
        <translation>СКО ускорения, Y, мм/с²</translation>
    </message>
    <message>
        <source>variation of angle X, degrees</source>
        <translation>разброс угла X, град.</translation>
    </message>
    <message>
        <source>variation of angle Y, degrees</source>
        <translation>разброс угла Y, град.</translation>
    </message>
    <message>
        <source>displacement over the foot of the chain, X, mm</source>
        <translation>перемещение относительно основания цепи, X, мм</translation>
    </message>
    <message>
        <source>displacement over the foot of the chain, Y, mm</source>
        <translation>перемещение относительно основания цепи, Y, мм</translation>
    </message>
    <message>
        <source>channel %1: </source>
        <translation>канал %1: </translation>
    </message>
    <message>
        <source>short circuit of the sensor line</source>
        <translation>короткое замыкание линии датчика</translation>
    </message>
    <message>
        <source>break of the sensor line</source>
        <translation>обрыв линии датчика</translation>
    </message>
    <message>
        <source>measurement %1: </source>
        <translation>измерение %1: </translation>
    </message>
    <message>
        <source>fault</source>
        <translation>неисправность</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>предупреждение</translation>
    </message>
    <message>
        <source>emergency stop</source>
        <translation>аварийный останов</translation>
    </message>
    <message>
        <source>the baseline is exceeded</source>
        <translation>превышена базовая линия</translation>
    </message>
    <message>
        <source>relay %1: </source>
        <translation>реле %1: </translation>
    </message>
    <message>
        <source>logical state</source>
        <translation>логическое состояние</translation>
    </message>
    <message>
        <source>physical state</source>
        <translation>физическое состояние</translation>
    </message>
    <message>
        <source>error</source>
        <translation>ошибка</translation>
    </message>
    <message>
        <source>its type, MEAS_TYPE</source>
        <translation>тип, MEAS_TYPE</translation>
    </message>
    <message>
        <source>value in the unit of the type</source>
        <translation>значение в единицах типа</translation>
    </message>
    <message>
        <source>percent of the scale</source>
        <translation>процент шкалы</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>среднее</translation>
    </message>
    <message>
        <source>instantaneous value</source>
        <translation>мгновенное значение</translation>
    </message>
    <message>
        <source>minimum</source>
        <translation>минимум</translation>
    </message>
    <message>
        <source>maximum</source>
        <translation>максимум</translation>
    </message>
    <message>
        <source>primary value, mean</source>
        <translation>первичное значение, среднее</translation>
    </message>
    <message>
        <source>primary value, instantaneous</source>
        <translation>первичное значение, мгновенное</translation>
    </message>
    <message>
        <source>maximum since the last request</source>
        <translation>максимум с последнего запроса</translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation>СКО</translation>
    </message>
    <message>
        <source>digital input, bit %1</source>
        <translation>цифровой вход, бит %1</translation>
    </message>
    <message>
        <source>it rains: the last event is a beginning</source>
        <translation>идут осадки: последнее событие — начало</translation>
    </message>
    <message>
        <source>V or Hz</source>
        <translation>В или Гц</translation>
    </message>
</context>
<context>
    <name>PlotText</name>
    <message>
        <source>Tilt</source>
        <translation>Наклон</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Температура</translation>
    </message>
    <message>
        <source>Heater power</source>
        <translation>Мощность подогрева</translation>
    </message>
    <message>
        <source>Fan</source>
        <translation>Вентилятор</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Ускорение</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Направление</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Перемещение</translation>
    </message>
    <message>
        <source>rev/s</source>
        <translation>об/с</translation>
    </message>
    <message>
        <source>mm/s²</source>
        <translation>мм/с²</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>P of the heater</source>
        <translation>P подогрева</translation>
    </message>
    <message>
        <source>Frequency of the fan</source>
        <translation>Частота вентилятора</translation>
    </message>
    <message>
        <source>Direction of Amax</source>
        <translation>Направление Amax</translation>
    </message>
    <message>
        <source>Displacement X</source>
        <translation>Перемещение X</translation>
    </message>
    <message>
        <source>Displacement Y</source>
        <translation>Перемещение Y</translation>
    </message>
    <message>
        <source>%1 d %2</source>
        <translation>%1 сут %2</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Ветер</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Давление</translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation>Влажность</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>м/с</translation>
    </message>
    <message>
        <source>mm Hg</source>
        <translation>мм рт. ст.</translation>
    </message>
    <message>
        <source>Wind speed</source>
        <translation>Скорость ветра</translation>
    </message>
    <message>
        <source>Wind direction</source>
        <translation>Направление ветра</translation>
    </message>
    <message>
        <source>Maximum wind speed</source>
        <translation>Максимальная скорость ветра</translation>
    </message>
</context>
<context>
    <name>PortPage</name>
    <message>
        <source>Comment</source>
        <translation>Комментарий</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <source>Polling time</source>
        <translation>Время опроса</translation>
    </message>
    <message>
        <source>Time since opening</source>
        <translation>Время после открытия</translation>
    </message>
    <message>
        <source>Bytes sent</source>
        <translation>Отправлено байт</translation>
    </message>
    <message>
        <source>Bytes received</source>
        <translation>Принято байт</translation>
    </message>
    <message>
        <source>Attempts to open</source>
        <translation>Попыток открытия</translation>
    </message>
    <message>
        <source>Write errors</source>
        <translation>Ошибок записи</translation>
    </message>
    <message>
        <source>Read errors</source>
        <translation>Ошибок чтения</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>Ошибок CRC</translation>
    </message>
    <message>
        <source>Code of the last error</source>
        <translation>Код последней ошибки</translation>
    </message>
    <message>
        <source>short description of the port</source>
        <translation>краткое описание подключенного порта</translation>
    </message>
    <message>
        <source>state of the port</source>
        <translation>состояние порта</translation>
    </message>
    <message>
        <source>how long the port is polled without a break, h:mm:ss</source>
        <translation>время непрерывного опроса порта, ч:мм:сс</translation>
    </message>
    <message>
        <source>how long the port works without a break, h:mm:ss</source>
        <translation>время непрерывной работы порта, ч:мм:сс</translation>
    </message>
    <message>
        <source>number of bytes sent to the port</source>
        <translation>количество отправленных в порт байт</translation>
    </message>
    <message>
        <source>number of bytes received from the port</source>
        <translation>количество принятых из порта байт</translation>
    </message>
    <message>
        <source>number of failed attempts to open the port</source>
        <translation>количество неудачных попыток открытия порта</translation>
    </message>
    <message>
        <source>number of errors of writing to the port</source>
        <translation>количество ошибок записи в порт</translation>
    </message>
    <message>
        <source>number of errors of reading from the port</source>
        <translation>количество ошибок чтения из порта</translation>
    </message>
    <message>
        <source>number of CRC errors in what was read from the port</source>
        <translation>количество ошибок CRC при чтении из порта</translation>
    </message>
    <message>
        <source>code of the system and its meaning; 0: no error so far</source>
        <translation>код системы и его смысл; 0 — ошибок не было</translation>
    </message>
</context>
<context>
    <name>RegisterMap</name>
    <message>
        <source>Channel word: two bits a port</source>
        <translation>Слово состояния канала: два бита на порт</translation>
    </message>
    <message>
        <source>mm/s²</source>
        <translation>мм/с²</translation>
    </message>
    <message>
        <source>Largest acceleration, modulus</source>
        <translation>Максимальное ускорение, модуль</translation>
    </message>
    <message>
        <source>Direction of the largest acceleration</source>
        <translation>Направление максимального ускорения</translation>
    </message>
    <message>
        <source>RMS of the acceleration along X</source>
        <translation>СКО ускорения по X</translation>
    </message>
    <message>
        <source>RMS of the acceleration along Y</source>
        <translation>СКО ускорения по Y</translation>
    </message>
    <message>
        <source>Status word of the sensor</source>
        <translation>Слово состояния датчика</translation>
    </message>
    <message>
        <source>Accelerations</source>
        <translation>Ускорения</translation>
    </message>
    <message>
        <source>What is not valid keeps its last value, 0 if it never had one; the status word says so.</source>
        <translation>Недостоверное значение остаётся последним известным, до первого измерения оно равно 0; об этом говорит слово состояния.</translation>
    </message>
    <message>
        <source>the slot belongs to a sensor</source>
        <translation>место занято датчиком</translation>
    </message>
    <message>
        <source>the sensor is switched on</source>
        <translation>датчик включён</translation>
    </message>
    <message>
        <source>its port is switched on</source>
        <translation>его порт включён</translation>
    </message>
    <message>
        <source>it answers</source>
        <translation>датчик отвечает</translation>
    </message>
    <message>
        <source>tilt is valid</source>
        <translation>углы наклона достоверны</translation>
    </message>
    <message>
        <source>temperature is valid</source>
        <translation>температура достоверна</translation>
    </message>
    <message>
        <source>accelerations are valid</source>
        <translation>ускорения достоверны</translation>
    </message>
    <message>
        <source>raw_status holds a word</source>
        <translation>raw_status содержит слово</translation>
    </message>
    <message>
        <source>raw_mode holds a word</source>
        <translation>raw_mode содержит слово</translation>
    </message>
    <message>
        <source>packets of samples are counted</source>
        <translation>пакеты отсчётов подсчитываются</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>углы наклона</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>температура</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>ускорения</translation>
    </message>
    <message>
        <source>thermostat</source>
        <translation>термостат</translation>
    </message>
    <message>
        <source>no type, never polled</source>
        <translation>тип не указан, не опрашивается</translation>
    </message>
    <message>
        <source>IN-D2, IN-D3, IN-D7, IN-D9</source>
        <translation>ИН-Д2, ИН-Д3, ИН-Д7, ИН-Д9</translation>
    </message>
    <message>
        <source>AN-D3</source>
        <translation>АН-Д3</translation>
    </message>
    <message>
        <source>USM-ISN</source>
        <translation>УСМ-ИСН</translation>
    </message>
    <message>
        <source>L-VIMS</source>
        <translation>L-VIMS</translation>
    </message>
    <message>
        <source>MK-14</source>
        <translation>МК-14</translation>
    </message>
    <message>
        <source>How many sensors have this status code</source>
        <translation>Сколько датчиков с этим кодом состояния</translation>
    </message>
    <message>
        <source>474F525Ah, the letters GORZ: this is the map</source>
        <translation>474F525Ah, буквы GORZ: признак этой карты</translation>
    </message>
    <message>
        <source>Version of the layout</source>
        <translation>Версия карты</translation>
    </message>
    <message>
        <source>How many slots there are</source>
        <translation>Сколько всего мест</translation>
    </message>
    <message>
        <source>Register where the directory starts</source>
        <translation>Регистр, с которого начинается каталог</translation>
    </message>
    <message>
        <source>Registers of an entry of the directory</source>
        <translation>Регистров в записи каталога</translation>
    </message>
    <message>
        <source>Register where the block of slot 0 starts</source>
        <translation>Регистр, с которого начинается блок места 0</translation>
    </message>
    <message>
        <source>Registers of a block</source>
        <translation>Регистров в блоке</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>Time of the answer, UTC, since 1970</source>
        <translation>Время ответа, UTC, от 1970 г.</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>Since the program started</source>
        <translation>От запуска программы</translation>
    </message>
    <message>
        <source>How many sensors there are</source>
        <translation>Сколько всего датчиков</translation>
    </message>
    <message>
        <source>How many of them answer</source>
        <translation>Сколько из них отвечают</translation>
    </message>
    <message>
        <source>How many of them are switched off</source>
        <translation>Сколько из них выключено</translation>
    </message>
    <message>
        <source>Site number N; 0: an empty slot</source>
        <translation>Номер датчика N; 0 – место пустое</translation>
    </message>
    <message>
        <source>Flags of the slot</source>
        <translation>Флаги места</translation>
    </message>
    <message>
        <source>Number of the port in the ini, 1…16</source>
        <translation>Номер порта в ini, 1…16</translation>
    </message>
    <message>
        <source>Address on the line</source>
        <translation>Адрес на линии</translation>
    </message>
    <message>
        <source>Type of the sensor</source>
        <translation>Тип датчика</translation>
    </message>
    <message>
        <source>What the sensor measures</source>
        <translation>Что измеряет датчик</translation>
    </message>
    <message>
        <source>The sensor&apos;s own status word</source>
        <translation>Собственное слово состояния датчика</translation>
    </message>
    <message>
        <source>The sensor&apos;s own mode word</source>
        <translation>Собственное слово режима датчика</translation>
    </message>
    <message>
        <source>Since the last answer; FFFFFFFFh: none so far</source>
        <translation>От последнего ответа; FFFFFFFFh – ответа не было</translation>
    </message>
    <message>
        <source>Time of the last answer, UTC, since 1970; 0: none so far</source>
        <translation>Время последнего ответа, UTC, от 1970 г.; 0 – ответа не было</translation>
    </message>
    <message>
        <source>Tilt along X</source>
        <translation>Угол наклона по X</translation>
    </message>
    <message>
        <source>Tilt along Y</source>
        <translation>Угол наклона по Y</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Температура</translation>
    </message>
    <message>
        <source>Power of the heater</source>
        <translation>Мощность нагревателя</translation>
    </message>
    <message>
        <source>1/s</source>
        <translation>1/с</translation>
    </message>
    <message>
        <source>Speed of the fan</source>
        <translation>Частота вращения вентилятора</translation>
    </message>
    <message>
        <source>Component of the largest acceleration along X</source>
        <translation>Составляющая максимального ускорения по X</translation>
    </message>
    <message>
        <source>Component of the largest acceleration along Y</source>
        <translation>Составляющая максимального ускорения по Y</translation>
    </message>
    <message>
        <source>RMS of the acceleration, modulus</source>
        <translation>СКО ускорения, модуль</translation>
    </message>
    <message>
        <source>Answers since the program started</source>
        <translation>Ответов от запуска программы</translation>
    </message>
    <message>
        <source>Failed reads since the program started</source>
        <translation>Ошибок чтения от запуска программы</translation>
    </message>
    <message>
        <source>Wrong check sums since the program started</source>
        <translation>Ошибок CRC от запуска программы</translation>
    </message>
    <message>
        <source>Packets of samples measured since the sensor started</source>
        <translation>Пакетов отсчётов измерено от запуска датчика</translation>
    </message>
    <message>
        <source>Packets of samples read since the program started</source>
        <translation>Пакетов отсчётов прочитано от запуска программы</translation>
    </message>
    <message>
        <source>Between the last two turns</source>
        <translation>Период двух последних опросов</translation>
    </message>
    <message>
        <source>How long the last turn took</source>
        <translation>Длительность последнего опроса</translation>
    </message>
    <message>
        <source>Directory</source>
        <translation>Каталог</translation>
    </message>
    <message>
        <source>Blocks of the sensors</source>
        <translation>Блоки датчиков</translation>
    </message>
    <message>
        <source>Extended map: every sensor of every type</source>
        <translation>Расширенная карта: все датчики всех типов</translation>
    </message>
    <message>
        <source>A number that is absent or not valid now is NaN (7FC00000h) where the type is float32, and 0 with a flag otherwise. Registers that are not listed are reserved and read 0. One request is answered from one moment: a value that it reads whole is never torn.</source>
        <translation>Отсутствующее или недостоверное сейчас число типа float32 равно NaN (7FC00000h), у остальных типов – 0, о чём говорит флаг. Не перечисленные регистры зарезервированы и читаются как 0. Ответ на один запрос относится к одному моменту: прочитанное целиком значение не бывает составлено из двух разных.</translation>
    </message>
    <message>
        <source>Bit</source>
        <translation>Бит</translation>
    </message>
    <message>
        <source>If it is set</source>
        <translation>Если установлен</translation>
    </message>
    <message>
        <source>the sensor is switched off</source>
        <translation>датчик выключен</translation>
    </message>
    <message>
        <source>tilt is not valid or not ready</source>
        <translation>углы наклона не достоверны или не готовы</translation>
    </message>
    <message>
        <source>temperature is not valid or not ready</source>
        <translation>температура не достоверна или не готова</translation>
    </message>
    <message>
        <source>accelerations are not valid or not ready</source>
        <translation>ускорения не достоверны или не готовы</translation>
    </message>
    <message>
        <source>samples of accelerations were lost</source>
        <translation>часть отсчётов ускорений потеряна (переполнение буфера обмена)</translation>
    </message>
    <message>
        <source>packets of samples do not follow each other</source>
        <translation>пакеты отсчётов идут не подряд (ошибка синхронизации)</translation>
    </message>
    <message>
        <source>the sensor has restarted</source>
        <translation>датчик перезапускался</translation>
    </message>
    <message>
        <source>the thermostat has not settled</source>
        <translation>терморегулирование не завершено</translation>
    </message>
    <message>
        <source>the heater is at its minimum</source>
        <translation>минимальная мощность нагрева</translation>
    </message>
    <message>
        <source>the heater is at its maximum</source>
        <translation>максимальная мощность нагрева</translation>
    </message>
    <message>
        <source>Bits 15…12</source>
        <translation>Биты 15…12</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Описание</translation>
    </message>
    <message>
        <source>Two bits</source>
        <translation>Два бита</translation>
    </message>
    <message>
        <source>The port</source>
        <translation>Порт</translation>
    </message>
    <message>
        <source>has no errors, or there is none</source>
        <translation>без ошибок или отсутствует</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>не открывается</translation>
    </message>
    <message>
        <source>was lost, or takes no bytes</source>
        <translation>пропал или не принимает данные</translation>
    </message>
    <message>
        <source>is switched off</source>
        <translation>выключен</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Код</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Датчики</translation>
    </message>
    <message>
        <source>Words and codes</source>
        <translation>Слова и коды</translation>
    </message>
    <message>
        <source>Channel word: port i in bits 2(i−1) and 2(i−1)+1</source>
        <translation>Слово состояния канала: порт i в битах 2(i−1) и 2(i−1)+1</translation>
    </message>
    <message>
        <source>Unit 1: flags</source>
        <translation>Устройство 1: flags (флаги)</translation>
    </message>
    <message>
        <source>Unit 1: quantities</source>
        <translation>Устройство 1: quantities (величины)</translation>
    </message>
    <message>
        <source>Unit 1: type</source>
        <translation>Устройство 1: type (тип)</translation>
    </message>
    <message>
        <source>Modbus register map</source>
        <translation>Карта регистров Modbus</translation>
    </message>
    <message>
        <source>The server is switched off in this configuration (CanModbus=0).</source>
        <translation>В этой конфигурации сервер выключен (CanModbus=0).</translation>
    </message>
    <message>
        <source>Modbus TCP, port %1. Nothing can be written.</source>
        <translation>Modbus TCP, порт %1. Только чтение.</translation>
    </message>
    <message>
        <source>ModbusPacking=ByNumber: in every unit slot 0 is N=1, slot 1 is N=2 and so on. Slots without a sensor are not listed; they hold the status word 0F00h and nothing else.</source>
        <translation>ModbusPacking=ByNumber: в каждом устройстве место 0 – N=1, место 1 – N=2 и так далее. Места без датчика не перечислены; в них только слово состояния 0F00h.</translation>
    </message>
    <message>
        <source>ModbusPacking=ByType: the sensors of a unit follow each other in ascending N, switched-off ones included. Their places change only when sensors are added to the ini or taken out.</source>
        <translation>ModbusPacking=ByType: датчики устройства идут подряд по возрастанию N, включая выключенные. Их места меняются, только если датчики добавлены в ini или убраны из него.</translation>
    </message>
    <message>
        <source>A register is given as in the request, counted from 0, and as programs give it that count from 1 and put the kind of register in front: 30001 is register 0 read with function 04, 40001 the same with function 03. Behind 39999 there are five digits: 310000.</source>
        <translation>Регистр указан так, как он стоит в запросе (счёт от 0), и так, как его указывают программы, которые считают от 1 и ставят впереди вид регистра: 30001 – регистр 0, читаемый функцией 04, 40001 – он же, функция 03. После 39999 цифр пять: 310000.</translation>
    </message>
    <message>
        <source>A request reads any part of a unit, at most 125 registers. Exceptions: 0B no such unit, 01 function, 03 quantity, 02 registers that do not exist.</source>
        <translation>Одним запросом читается любая часть устройства, не более 125 регистров. Исключения: 0B – нет такого устройства, 01 – функция, 03 – количество, 02 – таких регистров нет.</translation>
    </message>
    <message>
        <source>Order of the bytes on the wire: A is the high byte of the value.</source>
        <translation>Порядок байтов при передаче: A – старший байт значения.</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Датчик</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Порт</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Адрес</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Место установки</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Включён</translation>
    </message>
    <message>
        <source>From register, unit %1</source>
        <translation>С регистра, устройство %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>да</translation>
    </message>
    <message>
        <source>no</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Регистр</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Регистров</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Поле</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Порядок</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Множитель</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Ед. изм.</translation>
    </message>
    <message>
        <source>All numbers low byte first, in the registers too: where usual Modbus has 1234h, there is 3412h. Swap the bytes of every register, and the registers of the channel word.</source>
        <translation>Все числа передаются младшим байтом вперёд, в том числе внутри регистров: там, где в обычном Modbus 1234h, здесь 3412h. Поменяйте местами байты каждого регистра, а у слова состояния канала ещё и регистры.</translation>
    </message>
    <message>
        <source>All numbers high byte first, of several registers the high one first, as Modbus is usually read.</source>
        <translation>Все числа передаются старшим байтом вперёд, из нескольких регистров первым идёт старший, как принято в Modbus.</translation>
    </message>
    <message>
        <source>Unit %1. %2</source>
        <translation>Устройство %1. %2</translation>
    </message>
    <message>
        <source>Function %1; registers %2…%3.</source>
        <translation>Функция %1; регистры %2…%3.</translation>
    </message>
    <message>
        <source>03 or 04</source>
        <translation>03 или 04</translation>
    </message>
    <message>
        <source>Bytes of the answer</source>
        <translation>Байты ответа</translation>
    </message>
    <message>
        <source>What they are</source>
        <translation>Что это</translation>
    </message>
    <message>
        <source>transaction, as in the request</source>
        <translation>транзакция, как в запросе</translation>
    </message>
    <message>
        <source>protocol, as in the request</source>
        <translation>протокол, как в запросе</translation>
    </message>
    <message>
        <source>how many bytes follow</source>
        <translation>сколько байтов следует</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>устройство</translation>
    </message>
    <message>
        <source>function</source>
        <translation>функция</translation>
    </message>
    <message>
        <source>how many bytes of data follow</source>
        <translation>сколько байтов данных следует</translation>
    </message>
    <message>
        <source>Example: function 04, %1 registers from register %2, of sensor N=%3</source>
        <translation>Пример: функция 04, количество регистров %1, начиная с регистра %2, датчик N=%3</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Запрос</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Ответ</translation>
    </message>
    <message>
        <source>Angles of tilt</source>
        <translation>Углы наклона</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <source>Displacement along X over the sensor&apos;s link of a chain</source>
        <translation>Перемещение по X на звене цепочки, где стоит датчик</translation>
    </message>
    <message>
        <source>Displacement along Y over the sensor&apos;s link of a chain</source>
        <translation>Перемещение по Y на звене цепочки, где стоит датчик</translation>
    </message>
    <message>
        <source>Displacement along X over the foot of the chain</source>
        <translation>Перемещение по X относительно основания цепочки</translation>
    </message>
    <message>
        <source>Displacement along Y over the foot of the chain</source>
        <translation>Перемещение по Y относительно основания цепочки</translation>
    </message>
    <message>
        <source>wind, weather and digital inputs are of now</source>
        <translation>ветер, погода и цифровые входы текущие</translation>
    </message>
    <message>
        <source>wind and weather</source>
        <translation>ветер и погода</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>м/с</translation>
    </message>
    <message>
        <source>Speed of the wind, mean</source>
        <translation>Скорость ветра, средняя</translation>
    </message>
    <message>
        <source>Direction of the wind, mean</source>
        <translation>Направление ветра, среднее</translation>
    </message>
    <message>
        <source>Largest speed of the wind in the last turns</source>
        <translation>Наибольшая скорость ветра за последние опросы</translation>
    </message>
    <message>
        <source>Standard deviation of the speed of the wind</source>
        <translation>Среднеквадратическое отклонение скорости ветра</translation>
    </message>
    <message>
        <source>mm Hg</source>
        <translation>мм рт. ст.</translation>
    </message>
    <message>
        <source>Pressure of the air</source>
        <translation>Давление воздуха</translation>
    </message>
    <message>
        <source>Humidity of the air</source>
        <translation>Влажность воздуха</translation>
    </message>
    <message>
        <source>Digital inputs of a weather station, bit 0 the first</source>
        <translation>Цифровые входы метеостанции, бит 0 — первый</translation>
    </message>
    <message>
        <source>Direction of the largest speed; 0: stations do not say it</source>
        <translation>Направление при наибольшей скорости; 0: станции его не сообщают</translation>
    </message>
    <message>
        <source>Standard deviation of the direction of the wind</source>
        <translation>Среднеквадратическое отклонение направления ветра</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Ветер</translation>
    </message>
    <message>
        <source>A station that does not answer keeps its last values, 0 if there never were any; the status word says so. FFFFh: the station answers, but has no such value.</source>
        <translation>У станции, которая не отвечает, остаются последние значения, 0, если их не было; об этом говорит слово состояния. FFFFh: станция отвечает, но такого значения у неё нет.</translation>
    </message>
    <message>
        <source>channels_at says where its channels are</source>
        <translation>channels_at говорит, где лежат его каналы</translation>
    </message>
    <message>
        <source>vibration</source>
        <translation>вибрация</translation>
    </message>
    <message>
        <source>Register where channel 0 of an L-VIMS starts; 0: the sensor has no channels</source>
        <translation>Регистр, с которого начинается канал 0 модуля L-VIMS; 0 — у датчика нет каналов</translation>
    </message>
    <message>
        <source>How many channels there are</source>
        <translation>Сколько каналов</translation>
    </message>
    <message>
        <source>Registers of a channel</source>
        <translation>Регистров на канал</translation>
    </message>
    <message>
        <source>Register where the relays of an L-VIMS start</source>
        <translation>Регистр, с которого начинаются реле модуля L-VIMS</translation>
    </message>
    <message>
        <source>Unit, if MeasUnit does not say another</source>
        <translation>Единица, если MeasUnit не задаёт другой</translation>
    </message>
    <message>
        <source>Unit 1: flags of a channel of L-VIMS</source>
        <translation>Устройство 1: флаги канала L-VIMS</translation>
    </message>
    <message>
        <source>Unit 1: flags of a measurement of L-VIMS</source>
        <translation>Устройство 1: флаги измерения L-VIMS</translation>
    </message>
    <message>
        <source>Unit 1: type of a measurement of L-VIMS</source>
        <translation>Устройство 1: тип измерения L-VIMS</translation>
    </message>
    <message>
        <source>Relays: bit R: relay R is known</source>
        <translation>Реле: бит R — состояние реле R известно</translation>
    </message>
    <message>
        <source>Relays: bit R: what the module has decided</source>
        <translation>Реле: бит R — что решил модуль</translation>
    </message>
    <message>
        <source>Relays: bit R: what the output shows</source>
        <translation>Реле: бит R — что на выходе</translation>
    </message>
    <message>
        <source>Relays: bit R: error</source>
        <translation>Реле: бит R — ошибка</translation>
    </message>
    <message>
        <source>Relays: bit R: enabled</source>
        <translation>Реле: бит R — разрешено</translation>
    </message>
    <message>
        <source>Line to the sensor: 0 good, 1 shorted, 2 broken; 65535 no data, not in use or not known now</source>
        <translation>Линия датчика: 0 исправна, 1 замыкание, 2 обрыв; 65535 — нет данных, канал отключён или сейчас неизвестно</translation>
    </message>
    <message>
        <source>Flags of the channel</source>
        <translation>Флаги канала</translation>
    </message>
    <message>
        <source>How many measurements are in use</source>
        <translation>Сколько измерений используется</translation>
    </message>
    <message>
        <source>Type of the measurement, 1…16; 0: not in use</source>
        <translation>Тип измерения, 1…16; 0 — не используется</translation>
    </message>
    <message>
        <source>Flags of the measurement</source>
        <translation>Флаги измерения</translation>
    </message>
    <message>
        <source>Value in the unit of the type</source>
        <translation>Значение в единицах типа</translation>
    </message>
    <message>
        <source>Share of the scale, %; without PercentCode the code of the module</source>
        <translation>Доля шкалы, %; без PercentCode — код модуля</translation>
    </message>
    <message>
        <source>Baseline, as the share of the scale</source>
        <translation>Базовый уровень, так же как доля шкалы</translation>
    </message>
    <message>
        <source>the channel is known now</source>
        <translation>состояние канала сейчас известно</translation>
    </message>
    <message>
        <source>it is in use</source>
        <translation>канал используется</translation>
    </message>
    <message>
        <source>the line to its sensor is shorted or broken</source>
        <translation>замыкание или обрыв линии его датчика</translation>
    </message>
    <message>
        <source>the measurement is in use</source>
        <translation>измерение используется</translation>
    </message>
    <message>
        <source>its value is valid</source>
        <translation>значение достоверно</translation>
    </message>
    <message>
        <source>its share of the scale is valid</source>
        <translation>доля шкалы достоверна</translation>
    </message>
    <message>
        <source>its baseline is valid</source>
        <translation>базовый уровень достоверен</translation>
    </message>
    <message>
        <source>it is far from its baseline</source>
        <translation>отклонение от базового уровня превышено</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>неисправность</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>предупреждение</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>останов</translation>
    </message>
    <message>
        <source>the module knows whether there is a fault</source>
        <translation>модуль знает, есть ли неисправность</translation>
    </message>
    <message>
        <source>it knows whether there is a warning</source>
        <translation>модуль знает, есть ли предупреждение</translation>
    </message>
    <message>
        <source>it knows whether there is a stop</source>
        <translation>модуль знает, есть ли останов</translation>
    </message>
    <message>
        <source>Channels and relays of L-VIMS</source>
        <translation>Каналы и реле L-VIMS</translation>
    </message>
</context>
<context>
    <name>SensorPage</name>
    <message>
        <source>modulus of the maximum, its direction, degrees (RMS of the modulus | along X, along Y), packets in the sensor : read (samples) saved</source>
        <translation>модуль максимума, его направление, град. (СКО модуля | по X, по Y), пакетов в датчике : прочитано (отсчётов) сохранено</translation>
    </message>
    <message>
        <source>maximum along X %1, along Y %2 mm/s²</source>
        <translation>максимум по X %1, по Y %2 мм/с²</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Комментарий</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <source>Angles Mx, My, degrees (arc-seconds)</source>
        <translation>Углы Мх, Му, град. (угл. сек.)</translation>
    </message>
    <message>
        <source>Accelerations Ax, Ay, mm/s²</source>
        <translation>Ускорения Ах, Ау, мм/с²</translation>
    </message>
    <message>
        <source>Temperature T, °C</source>
        <translation>Температура Т, град.</translation>
    </message>
    <message>
        <source>Wind speed U, V, m/s</source>
        <translation>Скорость ветра U, V, м/с</translation>
    </message>
    <message>
        <source>Thermostat, % (rev/s)</source>
        <translation>Термостат, % (об./с)</translation>
    </message>
    <message>
        <source>Status word</source>
        <translation>Слово состояния</translation>
    </message>
    <message>
        <source>Polling period, s</source>
        <translation>Период опроса, с</translation>
    </message>
    <message>
        <source>Read errors</source>
        <translation>Ошибок чтения</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>Ошибок CRC</translation>
    </message>
    <message>
        <source>asked once a minute if CanInfo=1</source>
        <translation>запрашивается раз в минуту при CanInfo=1</translation>
    </message>
    <message>
        <source>a number as the sensor gives it</source>
        <translation>число, как его передаёт датчик</translation>
    </message>
    <message>
        <source>Firmware version</source>
        <translation>Версия ПО</translation>
    </message>
    <message>
        <source>System clock</source>
        <translation>Системный такт</translation>
    </message>
    <message>
        <source>Power of the heater</source>
        <translation>Мощность нагревателя</translation>
    </message>
    <message>
        <source>Power of the fan</source>
        <translation>Мощность вентилятора</translation>
    </message>
    <message>
        <source>Address and command of the transducer</source>
        <translation>Адрес и команда преобразователя</translation>
    </message>
    <message>
        <source>Response time of the transducer</source>
        <translation>Время ответа преобразователя</translation>
    </message>
    <message>
        <source>flags of the state : flags of the mode, as the sensor gives them</source>
        <translation>флаги состояния : флаги режима работы, как их передаёт датчик</translation>
    </message>
    <message>
        <source>the program&apos;s own word: %1</source>
        <translation>слово состояния программы: %1</translation>
    </message>
    <message>
        <source>short description of the sensor</source>
        <translation>краткое описание подключенного датчика</translation>
    </message>
    <message>
        <source>state of the sensor</source>
        <translation>состояние подключенного датчика</translation>
    </message>
    <message>
        <source>angle along X, angle along Y, degrees (the same in arc-seconds)</source>
        <translation>угол по X, угол по Y, угл. град. (угол по X, угол по Y, угл. сек.)</translation>
    </message>
    <message>
        <source>temperature, if the sensor measures it</source>
        <translation>температура, °C (если поддерживается датчиком)</translation>
    </message>
    <message>
        <source>speed of the wind, if the sensor measures it</source>
        <translation>скорость ветра (если поддерживается датчиком)</translation>
    </message>
    <message>
        <source>power of the heater, % (frequency of the fan, revolutions per second)</source>
        <translation>мощность нагревательного элемента, % (частота вентилятора, об./с)</translation>
    </message>
    <message>
        <source>actual period of polling | time of the exchange | age of the values</source>
        <translation>фактический период опроса | длительность обмена | возраст показаний</translation>
    </message>
    <message>
        <source>number of errors of reading from the sensor</source>
        <translation>количество ошибок чтения из датчика</translation>
    </message>
    <message>
        <source>number of CRC errors in what was read from the sensor</source>
        <translation>количество ошибок CRC при чтении из датчика</translation>
    </message>
</context>
<context>
    <name>ServerConfig</name>
    <message>
        <source>%1 is the port of [%2] already.</source>
        <translation>%1 уже занят секцией [%2].</translation>
    </message>
    <message>
        <source>The port is switched off.</source>
        <translation>Порт выключен.</translation>
    </message>
    <message>
        <source>Number %1 belongs to sensor %2 of [%3].</source>
        <translation>Номер %1 уже у датчика %2 секции [%3].</translation>
    </message>
    <message>
        <source>The sensor is listed as number %1.</source>
        <translation>Датчик показан под номером %1.</translation>
    </message>
    <message>
        <source>The sensor is switched off and listed as number %1.</source>
        <translation>Датчик выключен и показан под номером %1.</translation>
    </message>
    <message>
        <source>Address %1 is that of sensor %2 on this port already.</source>
        <translation>Адрес %1 на этом порту уже у датчика %2.</translation>
    </message>
    <message>
        <source>Sensor %1 is switched off.</source>
        <translation>Датчик %1 выключен.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>строка %1</translation>
    </message>
    <message>
        <source>… and %1 more.</source>
        <translation>… и ещё %1.</translation>
    </message>
    <message>
        <source>%1 is not tcp://host:port.</source>
        <translation>%1 — не tcp://узел:порт.</translation>
    </message>
    <message>
        <source>%1 is no kind of device that is known.</source>
        <translation>%1 — неизвестный вид устройства.</translation>
    </message>
    <message>
        <source>NumOfPorts is %1, but at most %2 are possible.</source>
        <translation>NumOfPorts равно %1, но возможно не более %2.</translation>
    </message>
    <message>
        <source>Only the first %1 are used.</source>
        <translation>Используются только первые %1.</translation>
    </message>
    <message>
        <source>NumOfPorts does not count this section.</source>
        <translation>NumOfPorts не учитывает эту секцию.</translation>
    </message>
    <message>
        <source>It is ignored.</source>
        <translation>Она пропущена.</translation>
    </message>
    <message>
        <source>There is no section [%1].</source>
        <translation>Нет секции [%1].</translation>
    </message>
    <message>
        <source>The port is left out.</source>
        <translation>Порт пропущен.</translation>
    </message>
    <message>
        <source>%1 is less than %2.</source>
        <translation>%1 меньше %2.</translation>
    </message>
    <message>
        <source>%1 is outside %2…%3.</source>
        <translation>%1 вне диапазона %2…%3.</translation>
    </message>
    <message>
        <source>%1 is not a whole number.</source>
        <translation>%1 — не целое число.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 — не число.</translation>
    </message>
    <message>
        <source>There is no value.</source>
        <translation>Нет значения.</translation>
    </message>
    <message>
        <source>%1 is none of %2.</source>
        <translation>%1 — не одно из: %2.</translation>
    </message>
    <message>
        <source>The default %1 is used.</source>
        <translation>Используется значение по умолчанию %1.</translation>
    </message>
    <message>
        <source>The sensor is listed under a free number.</source>
        <translation>Датчик показан под свободным номером.</translation>
    </message>
    <message>
        <source>The sensor is switched off.</source>
        <translation>Датчик выключен.</translation>
    </message>
    <message>
        <source>The name of sensor %1 says no type of sensor.</source>
        <translation>В имени датчика %1 не указан тип датчика.</translation>
    </message>
    <message>
        <source>NumOfSensors is %1, but at most %2 are possible.</source>
        <translation>NumOfSensors равно %1, но возможно не более %2.</translation>
    </message>
    <message>
        <source>NumOfSensors is %1, but these have neither adr nor Name: %2.</source>
        <translation>NumOfSensors равно %1, но нет ни adr, ни Name у датчиков: %2.</translation>
    </message>
    <message>
        <source>They are left out.</source>
        <translation>Они пропущены.</translation>
    </message>
    <message>
        <source>NumOfSensors is %1, but %2 more are listed.</source>
        <translation>NumOfSensors равно %1, но описано ещё %2.</translation>
    </message>
    <message>
        <source>They are ignored.</source>
        <translation>Они пропущены.</translation>
    </message>
    <message>
        <source>CanOPCDA=1 allows one copy of the program only.</source>
        <translation>CanOPCDA=1 допускает только одну копию программы.</translation>
    </message>
    <message>
        <source>CanCopy=0 is used.</source>
        <translation>Используется CanCopy=0.</translation>
    </message>
    <message>
        <source>The defaults of all its settings are used.</source>
        <translation>Для всех её настроек используются значения по умолчанию.</translation>
    </message>
    <message>
        <source>The file has no sections.</source>
        <translation>В файле нет секций.</translation>
    </message>
    <message>
        <source>The defaults of all settings are used, nothing is polled.</source>
        <translation>Для всех настроек используются значения по умолчанию, опроса нет.</translation>
    </message>
    <message>
        <source>There is no section [Common].</source>
        <translation>Нет секции [Common].</translation>
    </message>
    <message>
        <source>The line stands before the first section.</source>
        <translation>Строка стоит до первой секции.</translation>
    </message>
    <message>
        <source>All settings before the first section are ignored.</source>
        <translation>Все настройки до первой секции пропущены.</translation>
    </message>
    <message>
        <source>The section begins in line %1 already.</source>
        <translation>Секция уже начата в строке %1.</translation>
    </message>
    <message>
        <source>Of a key in both, the first one counts.</source>
        <translation>Из одинаковых ключей действует первый.</translation>
    </message>
    <message>
        <source>The key stands in line %1 already.</source>
        <translation>Ключ уже есть в строке %1.</translation>
    </message>
    <message>
        <source>The first one counts.</source>
        <translation>Действует первый.</translation>
    </message>
    <message>
        <source>%1 is more than %2.</source>
        <translation>%1 больше %2.</translation>
    </message>
    <message>
        <source>The text is longer than %1 characters.</source>
        <translation>Текст длиннее %1 символов.</translation>
    </message>
    <message>
        <source>Its beginning is used.</source>
        <translation>Взято его начало.</translation>
    </message>
    <message>
        <source>%1 is the port of Modbus TCP already.</source>
        <translation>%1 — уже порт Modbus TCP.</translation>
    </message>
    <message>
        <source>ADC24 TCP is switched off.</source>
        <translation>ADC24 TCP выключен.</translation>
    </message>
    <message>
        <source>The first accelerometer is used.</source>
        <translation>Используется первый акселерометр.</translation>
    </message>
    <message>
        <source>The site has no accelerometer with number %1.</source>
        <translation>На объекте нет акселерометра с номером %1.</translation>
    </message>
    <message>
        <source>It is not used.</source>
        <translation>Значение не используется.</translation>
    </message>
    <message>
        <source>TLS=0 needs no certificates.</source>
        <translation>При TLS=0 сертификаты не нужны.</translation>
    </message>
    <message>
        <source>CertFile and KeyFile belong together, one of them is missing.</source>
        <translation>CertFile и KeyFile указываются вместе, одного из них нет.</translation>
    </message>
    <message>
        <source>PasswordFile gives the password already.</source>
        <translation>Пароль уже задан ключом PasswordFile.</translation>
    </message>
    <message>
        <source>%1 has a # or a +, which topics must not have.</source>
        <translation>%1 содержит # или +, которых в топиках быть не должно.</translation>
    </message>
    <message>
        <source>The default is used.</source>
        <translation>Используется значение по умолчанию.</translation>
    </message>
    <message>
        <source>The chain is left out.</source>
        <translation>Цепочка не используется.</translation>
    </message>
    <message>
        <source>The site has no tilt sensor with number %1.</source>
        <translation>На объекте нет датчика наклона с номером %1.</translation>
    </message>
    <message>
        <source>Sensor %1 stands in a chain already.</source>
        <translation>Датчик %1 уже стоит в цепочке.</translation>
    </message>
    <message>
        <source>The chain has no links.</source>
        <translation>В цепочке нет звеньев.</translation>
    </message>
    <message>
        <source>The length L%1 of link %1, in metres, is missing.</source>
        <translation>Не задана длина L%1 звена %1 в метрах.</translation>
    </message>
    <message>
        <source>QPSQL needs Host and Database.</source>
        <translation>Для QPSQL нужны Host и Database.</translation>
    </message>
    <message>
        <source>The archive is a file, as with QSQLITE.</source>
        <translation>Архив ведётся в файле, как при QSQLITE.</translation>
    </message>
    <message>
        <source>Rollups cannot be removed before the readings of KeepRaw.</source>
        <translation>Сводки нельзя удалять раньше показаний KeepRaw.</translation>
    </message>
    <message>
        <source>They are kept as long as those.</source>
        <translation>Они хранятся столько же.</translation>
    </message>
    <message>
        <source>An archive needs at least %1 MB.</source>
        <translation>Архиву нужно не менее %1 МБ.</translation>
    </message>
    <message>
        <source>That size is used.</source>
        <translation>Используется этот размер.</translation>
    </message>
    <message>
        <source>Only an archive of QSQLITE has it.</source>
        <translation>Этот ключ есть только у архива QSQLITE.</translation>
    </message>
    <message>
        <source>It is ignored. KeepRaw and KeepSamples bound the archive.</source>
        <translation>Он не учитывается. Архив ограничивают KeepRaw и KeepSamples.</translation>
    </message>
    <message>
        <source>The folder of the station is missing behind %1.</source>
        <translation>За %1 не указана папка станции.</translation>
    </message>
    <message>
        <source>%1 is the port of %2 already.</source>
        <translation>%1 — это уже порт %2.</translation>
    </message>
    <message>
        <source>OPC DA is not served until another port is given.</source>
        <translation>OPC DA не обслуживается, пока не задан другой порт.</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 мс</translation>
    </message>
    <message>
        <source>[Server]</source>
        <translation>[Сервер]</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Комментарий</translation>
    </message>
    <message>
        <source>IP port</source>
        <translation>IP порт</translation>
    </message>
    <message>
        <source>slice of any pause</source>
        <translation>квант времени для задержек</translation>
    </message>
    <message>
        <source>[More]</source>
        <translation>[Дополнительно]</translation>
    </message>
    <message>
        <source>Save to files</source>
        <translation>Сохранять в файле</translation>
    </message>
    <message>
        <source>Records shown</source>
        <translation>Отображать записей</translation>
    </message>
    <message>
        <source>Records cleared</source>
        <translation>Очищать записей</translation>
    </message>
    <message>
        <source>Hide to the tray at the start</source>
        <translation>Сворачивать в трей при запуске</translation>
    </message>
    <message>
        <source>Warn at the end of work</source>
        <translation>Предупреждать при завершении работы</translation>
    </message>
    <message>
        <source>Allow a second copy</source>
        <translation>Разрешать запуск копии</translation>
    </message>
    <message>
        <source>Allow adjustment</source>
        <translation>Разрешить настройку</translation>
    </message>
    <message>
        <source>Accelerometer&apos;s buffer</source>
        <translation>Буфер акселерометра</translation>
    </message>
    <message>
        <source>%1 packets</source>
        <translation>%1 пакетов</translation>
    </message>
    <message>
        <source>[Port]</source>
        <translation>[Порт]</translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation>Включен</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Номер</translation>
    </message>
    <message>
        <source>%1 baud</source>
        <translation>%1 бод</translation>
    </message>
    <message>
        <source>[Sensor]</source>
        <translation>[Датчик]</translation>
    </message>
    <message>
        <source>Polling</source>
        <translation>Опрос</translation>
    </message>
    <message>
        <source>Number on the site</source>
        <translation>Порядковый номер</translation>
    </message>
    <message>
        <source>Address on the line</source>
        <translation>Адрес на линии</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Серийный номер</translation>
    </message>
    <message>
        <source>[Adjustment]</source>
        <translation>[Юстировка]</translation>
    </message>
    <message>
        <source>Offset Mx, degrees (arc-seconds)</source>
        <translation>Смещение Mx, град. (угл. сек.)</translation>
    </message>
    <message>
        <source>Offset My, degrees (arc-seconds)</source>
        <translation>Смещение My, град. (угл. сек.)</translation>
    </message>
    <message>
        <source>Offset T, °C</source>
        <translation>Смещение T, град.</translation>
    </message>
    <message>
        <source>Inversion of axis Y</source>
        <translation>Инверсия оси Y</translation>
    </message>
    <message>
        <source>Rotation of axis X, degrees</source>
        <translation>Поворот оси X, град.</translation>
    </message>
    <message>
        <source>Date of installation</source>
        <translation>Дата установки</translation>
    </message>
    <message>
        <source>Date of the last adjustment</source>
        <translation>Дата последней юстировки</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Примечание</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>even</source>
        <translation>чётность</translation>
    </message>
    <message>
        <source>odd</source>
        <translation>нечётность</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>единица</translation>
    </message>
    <message>
        <source>space</source>
        <translation>ноль</translation>
    </message>
    <message>
        <source>angles</source>
        <translation>углы</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>температура</translation>
    </message>
    <message>
        <source>accelerations</source>
        <translation>ускорения</translation>
    </message>
    <message>
        <source>information about the sensor; its keywords tell what the sensor is able to do</source>
        <translation>информация о датчике; ключевые слова задают аппаратные возможности датчика</translation>
    </message>
    <message>
        <source>take the sensor into the polling cycle?</source>
        <translation>включать датчик в цикл опроса?</translation>
    </message>
    <message>
        <source>number of the sensor on the site</source>
        <translation>порядковый номер датчика на объекте</translation>
    </message>
    <message>
        <source>address of the sensor on the line</source>
        <translation>адрес датчика на линии</translation>
    </message>
    <message>
        <source>works number of the primary transducer</source>
        <translation>заводской номер первичного преобразователя</translation>
    </message>
    <message>
        <source>zero offset along X after the adjustment; in the file in arc-seconds</source>
        <translation>смещение нуля датчика по X после юстировки; в файле — угл. сек.</translation>
    </message>
    <message>
        <source>zero offset along Y after the adjustment; in the file in arc-seconds</source>
        <translation>смещение нуля датчика по Y после юстировки; в файле — угл. сек.</translation>
    </message>
    <message>
        <source>zero correction of the temperature sensor, °C; sensors without temperature have none</source>
        <translation>коррекция нуля датчика температуры, °C; у датчиков без температуры отсутствует</translation>
    </message>
    <message>
        <source>invert the axis Y of the sensor&apos;s coordinate system?</source>
        <translation>инвертировать ось Y системы координат датчика?</translation>
    </message>
    <message>
        <source>angle of the sensor&apos;s coordinate system against that of the site, degrees</source>
        <translation>угол вращения системы координат датчика по отношению к системе координат объекта, угл. град.</translation>
    </message>
    <message>
        <source>date when the sensor was installed</source>
        <translation>дата установки датчика</translation>
    </message>
    <message>
        <source>date when the sensor was last adjusted</source>
        <translation>дата последней юстировки</translation>
    </message>
    <message>
        <source>additional information about the sensor</source>
        <translation>дополнительная информация о датчике</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Место установки</translation>
    </message>
    <message>
        <source>place of the sensor, shown in the tree</source>
        <translation>место установки датчика, показывается в дереве</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <source>by the keywords of the comment</source>
        <translation>по ключевым словам комментария</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Измеряет</translation>
    </message>
    <message>
        <source>what the type is able to measure; AccelOn=0 leaves out the accelerations</source>
        <translation>что умеет измерять датчик этого типа; AccelOn=0 исключает ускорения</translation>
    </message>
    <message>
        <source>Thermostat</source>
        <translation>Термостат</translation>
    </message>
    <message>
        <source>by the keywords of the comment; fan and heater count in the status word</source>
        <translation>по ключевым словам комментария; вентилятор и нагрев учитываются в слове состояния</translation>
    </message>
    <message>
        <source>an option of this type of sensor</source>
        <translation>параметр датчиков этого типа</translation>
    </message>
    <message>
        <source>short description of the port&apos;s adapter</source>
        <translation>краткое описание адаптера порта</translation>
    </message>
    <message>
        <source>take the port into the polling cycle?</source>
        <translation>включать порт в цикл опроса?</translation>
    </message>
    <message>
        <source>name of the port in the operating system</source>
        <translation>название порта в ОС</translation>
    </message>
    <message>
        <source>speed of transmission, baud</source>
        <translation>скорость передачи, бод</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Устройство</translation>
    </message>
    <message>
        <source>opened instead of the port of that number: a path, COM4, tcp://host:port, sim:</source>
        <translation>открывается вместо порта с этим номером: путь, COM4, tcp://узел:порт, sim:</translation>
    </message>
    <message>
        <source>Data bits</source>
        <translation>Биты данных</translation>
    </message>
    <message>
        <source>5 … 8</source>
        <translation>5 … 8</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>Чётность</translation>
    </message>
    <message>
        <source>N, E, O, M or S</source>
        <translation>N, E, O, M или S</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>Стоповые биты</translation>
    </message>
    <message>
        <source>1, 1.5 or 2</source>
        <translation>1, 1.5 или 2</translation>
    </message>
    <message>
        <source>does the driver of the adapter control the direction?</source>
        <translation>направлением передачи управляет драйвер адаптера?</translation>
    </message>
    <message>
        <source>Sensors listed</source>
        <translation>Датчиков в списке</translation>
    </message>
    <message>
        <source>number of sensors connected to the port</source>
        <translation>количество подключенных к порту датчиков</translation>
    </message>
    <message>
        <source>short description of this copy of the program</source>
        <translation>краткое описание копии программы</translation>
    </message>
    <message>
        <source>number of the IP port for Modbus TCP</source>
        <translation>номер IP порта для протокола Modbus TCP</translation>
    </message>
    <message>
        <source>number of the IP port for Modbus TCP, switched off by CanModbus=0</source>
        <translation>номер IP порта для протокола Modbus TCP, выключен (CanModbus=0)</translation>
    </message>
    <message>
        <source>period of drawing the visible elements of the program</source>
        <translation>период обновления визуальных элементов программы</translation>
    </message>
    <message>
        <source>period of polling the COM ports</source>
        <translation>период опроса COM-портов</translation>
    </message>
    <message>
        <source>time for resources of the program at its start</source>
        <translation>время, выделяемое для инициализации ресурсов программы</translation>
    </message>
    <message>
        <source>period of saving the measurements in files</source>
        <translation>период сохранения результатов измерений в файлах</translation>
    </message>
    <message>
        <source>pause after a failed attempt to open a COM port</source>
        <translation>задержка после неудачной попытки открытия COM-порта</translation>
    </message>
    <message>
        <source>pause after closing a COM port, before it is opened again</source>
        <translation>задержка после закрытия COM-порта перед повторным открытием</translation>
    </message>
    <message>
        <source>time for an orderly end of the program; then it is ended by force</source>
        <translation>время на штатное освобождение ресурсов программы при закрытии; затем она закрывается аварийно</translation>
    </message>
    <message>
        <source>pause after another address is chosen</source>
        <translation>время приостановки процесса после изменения адреса датчика</translation>
    </message>
    <message>
        <source>pause after a polling cycle</source>
        <translation>время приостановки процесса после завершения цикла опроса</translation>
    </message>
    <message>
        <source>pause after a read error</source>
        <translation>время приостановки процесса после ошибки чтения</translation>
    </message>
    <message>
        <source>pause after a CRC error</source>
        <translation>время приостановки процесса после ошибки CRC</translation>
    </message>
    <message>
        <source>timeout of reading a command from a COM port</source>
        <translation>таймаут чтения команды из COM-порта</translation>
    </message>
    <message>
        <source>timeout of writing a command to a COM port</source>
        <translation>таймаут записи команды в COM-порт</translation>
    </message>
    <message>
        <source>timeout of reading data from a COM port</source>
        <translation>таймаут чтения данных из COM-порта</translation>
    </message>
    <message>
        <source>timeout of writing data to a COM port</source>
        <translation>таймаут записи данных в COM-порт</translation>
    </message>
    <message>
        <source>read errors in a row before the status word of the sensor says so</source>
        <translation>количество ошибок чтения подряд, после которых выставляется флаг слова состояния датчика</translation>
    </message>
    <message>
        <source>CRC errors in a row before the status word of the sensor says so</source>
        <translation>количество ошибок CRC подряд, после которых выставляется флаг слова состояния датчика</translation>
    </message>
    <message>
        <source>save measurements and the journal of events in files?</source>
        <translation>сохранять результаты измерений и журнал событий в файлах?</translation>
    </message>
    <message>
        <source>number of the last records on the tab of measurements</source>
        <translation>количество последних записей, отображаемых во вкладке измерений</translation>
    </message>
    <message>
        <source>number of records removed from the tab of measurements when it is full</source>
        <translation>количество записей во вкладке измерений, которые удаляются после переполнения</translation>
    </message>
    <message>
        <source>hide the window of the program in the tray at its start?</source>
        <translation>сворачивать окно программы в трей при запуске?</translation>
    </message>
    <message>
        <source>show a warning when the program is closed? (CanClose=0)</source>
        <translation>выводить окно предупреждения при закрытии программы? (CanClose=0)</translation>
    </message>
    <message>
        <source>allow copies of the program to run at the same time?</source>
        <translation>разрешать одновременный запуск копий программы?</translation>
    </message>
    <message>
        <source>show additional elements of the program?</source>
        <translation>отображать дополнительные элементы программы?</translation>
    </message>
    <message>
        <source>size of the accelerometer&apos;s ring; a packet holds 32 samples along X and Y</source>
        <translation>размер циклического буфера акселерометра; в пакете 32 измерения по X и Y</translation>
    </message>
    <message>
        <source>[Program]</source>
        <translation>[Программа]</translation>
    </message>
    <message>
        <source>Caption of the window</source>
        <translation>Заголовок окна</translation>
    </message>
    <message>
        <source>title of the window</source>
        <translation>текст заголовка окна программы</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Язык</translation>
    </message>
    <message>
        <source>language of the program: ru or en; --lang goes before it</source>
        <translation>язык программы: ru или en; ключ --lang важнее</translation>
    </message>
    <message>
        <source>Serial number of the copy</source>
        <translation>Серийный номер копии</translation>
    </message>
    <message>
        <source>kept, without any effect</source>
        <translation>хранится, на работу не влияет</translation>
    </message>
    <message>
        <source>Ports listed</source>
        <translation>Портов в списке</translation>
    </message>
    <message>
        <source>number of COM ports in the configuration file</source>
        <translation>количество COM-портов в файле настроек</translation>
    </message>
    <message>
        <source>Ask for information</source>
        <translation>Запрашивать информацию</translation>
    </message>
    <message>
        <source>ask sensors for additional information about their state?</source>
        <translation>запрашивать дополнительную информацию о состоянии датчика?</translation>
    </message>
    <message>
        <source>Buffers in a file</source>
        <translation>Буферов в файле</translation>
    </message>
    <message>
        <source>samples of acceleration in one binary file: %1 (SrsBufSize × 32 × SrsBufToSave)</source>
        <translation>измерений ускорений в одном двоичном файле: %1 (SrsBufSize × 32 × SrsBufToSave)</translation>
    </message>
    <message>
        <source>Gravity, m/s²</source>
        <translation>Ускорение св. падения, м/с²</translation>
    </message>
    <message>
        <source>acceleration of free fall, by which raw accelerations become mm/s²</source>
        <translation>ускорение свободного падения для пересчёта ускорений в мм/с²</translation>
    </message>
    <message>
        <source>Status bits of the original</source>
        <translation>Биты статуса прежней программы</translation>
    </message>
    <message>
        <source>print the status words as the original program did?</source>
        <translation>выдавать слова состояния так, как прежняя программа?</translation>
    </message>
    <message>
        <source>IP port of ADC24</source>
        <translation>IP порт ADC24</translation>
    </message>
    <message>
        <source>number of the IP port for ADC24 TCP</source>
        <translation>номер IP порта для протокола ADC24 TCP</translation>
    </message>
    <message>
        <source>OPC DA interface</source>
        <translation>Интерфейс OPC DA</translation>
    </message>
    <message>
        <source>serve OPC DA? Only one copy of the program may run then</source>
        <translation>передавать данные по OPC DA? Тогда работает только одна копия программы</translation>
    </message>
    <message>
        <source>Modbus TCP server</source>
        <translation>Сервер Modbus TCP</translation>
    </message>
    <message>
        <source>serve readings over Modbus TCP?</source>
        <translation>передавать показания по протоколу Modbus TCP?</translation>
    </message>
    <message>
        <source>Order of the sensors</source>
        <translation>Порядок датчиков</translation>
    </message>
    <message>
        <source>by type</source>
        <translation>по типам</translation>
    </message>
    <message>
        <source>by number</source>
        <translation>по номерам</translation>
    </message>
    <message>
        <source>in units 3 and 6: every sensor of the type in turn, or a place for every site number</source>
        <translation>в адресах 3 и 6: датчики своего типа подряд или место для каждого номера на объекте</translation>
    </message>
    <message>
        <source>First register</source>
        <translation>Первый регистр</translation>
    </message>
    <message>
        <source>where the registers of units 3 and 6 start: 0 or 1</source>
        <translation>с чего начинаются регистры адресов 3 и 6: 0 или 1</translation>
    </message>
    <message>
        <source>Clients at most</source>
        <translation>Клиентов не более</translation>
    </message>
    <message>
        <source>connections at the same time</source>
        <translation>количество одновременных подключений</translation>
    </message>
    <message>
        <source>Cut off silent clients</source>
        <translation>Отключать молчащих клиентов</translation>
    </message>
    <message>
        <source>after %1 s</source>
        <translation>через %1 с</translation>
    </message>
    <message>
        <source>never</source>
        <translation>никогда</translation>
    </message>
    <message>
        <source>how long a client may ask nothing</source>
        <translation>сколько клиент может не присылать запросов</translation>
    </message>
    <message>
        <source>Address of the server</source>
        <translation>Адрес сервера</translation>
    </message>
    <message>
        <source>all</source>
        <translation>все</translation>
    </message>
    <message>
        <source>IP address of this computer to serve on</source>
        <translation>IP-адрес этого компьютера, на котором принимаются подключения</translation>
    </message>
    <message>
        <source>Clients allowed</source>
        <translation>Разрешённые клиенты</translation>
    </message>
    <message>
        <source>addresses and blocks of addresses that may connect</source>
        <translation>адреса и блоки адресов, которым разрешено подключаться</translation>
    </message>
    <message>
        <source>the file gives “%1”, which cannot be used; “%2” is used</source>
        <translation>в файле указано «%1», это значение использовать нельзя; используется «%2»</translation>
    </message>
    <message>
        <source>ADC24 TCP server</source>
        <translation>Сервер ADC24 TCP</translation>
    </message>
    <message>
        <source>serve the samples of one accelerometer over ADC24 TCP?</source>
        <translation>отдавать отсчёты одного акселерометра по ADC24 TCP?</translation>
    </message>
    <message>
        <source>Accelerometer served</source>
        <translation>Отдаваемый акселерометр</translation>
    </message>
    <message>
        <source>the first</source>
        <translation>первый</translation>
    </message>
    <message>
        <source>number of the sensor whose samples are served</source>
        <translation>номер датчика, отсчёты которого отдаются</translation>
    </message>
    <message>
        <source>Axis served</source>
        <translation>Отдаваемая ось</translation>
    </message>
    <message>
        <source>X or Y: the axis whose samples are served</source>
        <translation>X или Y: ось, отсчёты по которой отдаются</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Пользователь</translation>
    </message>
    <message>
        <source>who the broker is told we are</source>
        <translation>имя, под которым программа входит на брокер</translation>
    </message>
    <message>
        <source>File with the password</source>
        <translation>Файл с паролем</translation>
    </message>
    <message>
        <source>its first line is the password</source>
        <translation>пароль — первая строка этого файла</translation>
    </message>
    <message>
        <source>Encrypted</source>
        <translation>Шифрование</translation>
    </message>
    <message>
        <source>connect to the broker with TLS?</source>
        <translation>соединяться с брокером по TLS?</translation>
    </message>
    <message>
        <source>Certificates trusted</source>
        <translation>Доверенные сертификаты</translation>
    </message>
    <message>
        <source>those of the system</source>
        <translation>системные</translation>
    </message>
    <message>
        <source>PEM file of who signed the broker&apos;s certificate</source>
        <translation>файл PEM того, кто подписал сертификат брокера</translation>
    </message>
    <message>
        <source>Own certificate</source>
        <translation>Свой сертификат</translation>
    </message>
    <message>
        <source>PEM file that the broker may ask for</source>
        <translation>файл PEM, который может запросить брокер</translation>
    </message>
    <message>
        <source>Its key</source>
        <translation>Ключ сертификата</translation>
    </message>
    <message>
        <source>PEM file of the key of the own certificate</source>
        <translation>файл PEM с ключом своего сертификата</translation>
    </message>
    <message>
        <source>Broker</source>
        <translation>Брокер</translation>
    </message>
    <message>
        <source>name or address of the broker that gets every reading</source>
        <translation>имя или адрес брокера, который получает каждое показание</translation>
    </message>
    <message>
        <source>Port of the broker</source>
        <translation>Порт брокера</translation>
    </message>
    <message>
        <source>usually 1883, with TLS 8883</source>
        <translation>обычно 1883, с TLS — 8883</translation>
    </message>
    <message>
        <source>Name for the broker</source>
        <translation>Имя клиента</translation>
    </message>
    <message>
        <source>made of the computer and the folder</source>
        <translation>по имени компьютера и папке</translation>
    </message>
    <message>
        <source>two copies with the same name throw each other out</source>
        <translation>две копии с одним именем вытесняют друг друга</translation>
    </message>
    <message>
        <source>Topics begin with</source>
        <translation>Начало тем</translation>
    </message>
    <message>
        <source>the name of this copy</source>
        <translation>имя этой копии</translation>
    </message>
    <message>
        <source>what stands before sensor/… and port/… in each topic</source>
        <translation>что стоит в каждой теме перед sensor/… и port/…</translation>
    </message>
    <message>
        <source>Quality of service</source>
        <translation>Качество доставки</translation>
    </message>
    <message>
        <source>0: may get lost, 1: at least once, 2: exactly once</source>
        <translation>0 — может потеряться, 1 — хотя бы раз, 2 — ровно один раз</translation>
    </message>
    <message>
        <source>least time between two readings of one sensor; 0: all</source>
        <translation>наименьшее время между двумя показаниями датчика; 0 — все</translation>
    </message>
    <message>
        <source>Queue at most</source>
        <translation>Очередь не более</translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation>%1 МиБ</translation>
    </message>
    <message>
        <source>readings that wait on the disk while the broker is away</source>
        <translation>показания ждут на диске, пока брокера нет</translation>
    </message>
    <message>
        <source>Metrics for Prometheus</source>
        <translation>Метрики для Prometheus</translation>
    </message>
    <message>
        <source>port %1</source>
        <translation>порт %1</translation>
    </message>
    <message>
        <source>off</source>
        <translation>выключены</translation>
    </message>
    <message>
        <source>number of the IP port where counters are served</source>
        <translation>номер IP-порта, на котором отдаются счётчики</translation>
    </message>
    <message>
        <source>Address of the metrics</source>
        <translation>Адрес метрик</translation>
    </message>
    <message>
        <source>IP address to serve on</source>
        <translation>IP-адрес, на котором отдаются метрики</translation>
    </message>
    <message>
        <source>%1 d</source>
        <translation>%1 сут</translation>
    </message>
    <message>
        <source>for ever</source>
        <translation>всегда</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>counted from the folder of the data</source>
        <translation>считается от папки данных</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Сервер</translation>
    </message>
    <message>
        <source>name or address of the PostgreSQL server</source>
        <translation>имя или адрес сервера PostgreSQL</translation>
    </message>
    <message>
        <source>Port of the server</source>
        <translation>Порт сервера</translation>
    </message>
    <message>
        <source>usually 5432</source>
        <translation>обычно 5432</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>База данных</translation>
    </message>
    <message>
        <source>name of the database there</source>
        <translation>имя базы данных на сервере</translation>
    </message>
    <message>
        <source>who writes into the database</source>
        <translation>кто пишет в базу данных</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Объект</translation>
    </message>
    <message>
        <source>schema of this site, so that many share a database</source>
        <translation>схема этого объекта: в одной базе их может быть много</translation>
    </message>
    <message>
        <source>Keep an archive</source>
        <translation>Вести архив</translation>
    </message>
    <message>
        <source>keep every reading, for trends and history?</source>
        <translation>хранить каждое показание для графиков и истории?</translation>
    </message>
    <message>
        <source>Kept in</source>
        <translation>Хранится</translation>
    </message>
    <message>
        <source>a file</source>
        <translation>в файле</translation>
    </message>
    <message>
        <source>PostgreSQL</source>
        <translation>PostgreSQL</translation>
    </message>
    <message>
        <source>QSQLITE: a file of its own; QPSQL: a PostgreSQL server</source>
        <translation>QSQLITE — отдельный файл; QPSQL — сервер PostgreSQL</translation>
    </message>
    <message>
        <source>Readings kept</source>
        <translation>Хранить показания</translation>
    </message>
    <message>
        <source>how long at full rate</source>
        <translation>сколько хранить все показания</translation>
    </message>
    <message>
        <source>Samples kept</source>
        <translation>Хранить отсчёты</translation>
    </message>
    <message>
        <source>how long the samples of accelerometers</source>
        <translation>сколько хранить отсчёты акселерометров</translation>
    </message>
    <message>
        <source>Sums kept</source>
        <translation>Хранить сводки</translation>
    </message>
    <message>
        <source>how long the sums of minutes, hours and days</source>
        <translation>сколько хранить сводки за минуты, часы и сутки</translation>
    </message>
    <message>
        <source>Events kept</source>
        <translation>Хранить события</translation>
    </message>
    <message>
        <source>how long events of the journal and gaps</source>
        <translation>сколько хранить события журнала и пропуски</translation>
    </message>
    <message>
        <source>Size at most</source>
        <translation>Размер не более</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 МБ</translation>
    </message>
    <message>
        <source>any</source>
        <translation>любой</translation>
    </message>
    <message>
        <source>the oldest goes first</source>
        <translation>сначала удаляется самое старое</translation>
    </message>
    <message>
        <source>what the sensors stand on</source>
        <translation>на чём стоят датчики</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>Звено %1</translation>
    </message>
    <message>
        <source>sensor %1, %2 m</source>
        <translation>датчик %1, %2 м</translation>
    </message>
    <message>
        <source>number of the sensor and length of its link, from the bottom</source>
        <translation>номер датчика и длина его звена, снизу вверх</translation>
    </message>
    <message>
        <source>Port for OPC DA gateways</source>
        <translation>Порт для шлюзов OPC DA</translation>
    </message>
    <message>
        <source>number of the IP port where gateways on this computer get the tags</source>
        <translation>номер IP порта, на котором шлюзы этого компьютера получают тэги</translation>
    </message>
    <message>
        <source>Gateways connected</source>
        <translation>Подключено шлюзов</translation>
    </message>
    <message>
        <source>each serves any number of OPC clients</source>
        <translation>каждый обслуживает любое число клиентов OPC</translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>restarted</source>
        <translation>перезагрузка датчика</translation>
    </message>
    <message>
        <source>samples were lost</source>
        <translation>потеряна часть отсчётов</translation>
    </message>
    <message>
        <source>samples do not follow each other</source>
        <translation>ошибка синхронизации</translation>
    </message>
    <message>
        <source>tilt is not ready</source>
        <translation>углы не готовы</translation>
    </message>
    <message>
        <source>temperature is not ready</source>
        <translation>температура не готова</translation>
    </message>
    <message>
        <source>acceleration is not ready</source>
        <translation>ускорения не готовы</translation>
    </message>
    <message>
        <source>the thermostat has not settled</source>
        <translation>терморегулирование не завершено</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Выключен</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Открывается</translation>
    </message>
    <message>
        <source>Open, polling</source>
        <translation>Открыт, идёт опрос</translation>
    </message>
    <message>
        <source>Cannot be opened</source>
        <translation>Не открывается</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Связь потеряна</translation>
    </message>
    <message>
        <source>Service mode, polling is suspended</source>
        <translation>Сервисный режим, опрос приостановлен</translation>
    </message>
    <message>
        <source>Unknown type of sensor, not polled</source>
        <translation>Неизвестный тип датчика, не опрашивается</translation>
    </message>
    <message>
        <source>Polling is off</source>
        <translation>Опрос отключен</translation>
    </message>
    <message>
        <source>Waiting for the first answer</source>
        <translation>Ожидание первого ответа</translation>
    </message>
    <message>
        <source>Answering</source>
        <translation>Отвечает</translation>
    </message>
    <message>
        <source>Answering: %1</source>
        <translation>Отвечает: %1</translation>
    </message>
    <message>
        <source>Everything works</source>
        <translation>Всё исправно</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>Запускается</translation>
    </message>
    <message>
        <source>Service mode</source>
        <translation>Сервисный режим</translation>
    </message>
    <message>
        <source>There are warnings</source>
        <translation>Есть предупреждения</translation>
    </message>
    <message>
        <source>There are errors</source>
        <translation>Есть ошибки</translation>
    </message>
    <message>
        <source>Sensors good: %1</source>
        <translation>Датчиков исправно: %1</translation>
    </message>
    <message>
        <source>with errors: %1</source>
        <translation>с ошибками: %1</translation>
    </message>
    <message>
        <source>with warnings: %1</source>
        <translation>с предупреждениями: %1</translation>
    </message>
    <message>
        <source>starting: %1</source>
        <translation>запускается: %1</translation>
    </message>
    <message>
        <source>in service: %1</source>
        <translation>в сервисе: %1</translation>
    </message>
    <message>
        <source>off: %1</source>
        <translation>выключено: %1</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>да</translation>
    </message>
    <message>
        <source>no</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>a channel has no data</source>
        <translation>в одном из каналов нет данных</translation>
    </message>
    <message>
        <source>fault, warning or stop of a measurement</source>
        <translation>неисправность, предупреждение или останов по измерению</translation>
    </message>
</context>
<context>
    <name>Station</name>
    <message>
        <source>seconds of a current value</source>
        <translation>секунд в мгновенном значении</translation>
    </message>
    <message>
        <source>gate, s</source>
        <translation>ворота, с</translation>
    </message>
    <message>
        <source>test mode</source>
        <translation>тестовый режим</translation>
    </message>
    <message>
        <source>current value</source>
        <translation>текущее значение</translation>
    </message>
    <message>
        <source>analogue inputs</source>
        <translation>аналоговые входы</translation>
    </message>
    <message>
        <source>digital inputs</source>
        <translation>цифровые входы</translation>
    </message>
    <message>
        <source>order of processing</source>
        <translation>порядок обработки</translation>
    </message>
    <message>
        <source>period of the timer, µs</source>
        <translation>период таймера, мкс</translation>
    </message>
    <message>
        <source>averaging in the board</source>
        <translation>осреднение в плате</translation>
    </message>
    <message>
        <source>first divider</source>
        <translation>первый делитель</translation>
    </message>
    <message>
        <source>second divider</source>
        <translation>второй делитель</translation>
    </message>
    <message>
        <source>frequency input</source>
        <translation>частотный вход</translation>
    </message>
    <message>
        <source>%1 is used.</source>
        <translation>Берётся %1.</translation>
    </message>
    <message>
        <source>The other letters are used.</source>
        <translation>Остальные буквы действуют.</translation>
    </message>
    <message>
        <source>There are more than %1 letters.</source>
        <translation>Букв больше %1.</translation>
    </message>
    <message>
        <source>%1 at place %2 is not a Latin letter.</source>
        <translation>%1 на месте %2 — не латинская буква.</translation>
    </message>
    <message>
        <source>12, or 10 without the AI16-5A</source>
        <translation>12 (10 без AI16-5A)</translation>
    </message>
    <message>
        <source>The file has %1 values instead of %2.</source>
        <translation>В файле значений: %1, нужно %2.</translation>
    </message>
    <message>
        <source>The board is left out.</source>
        <translation>Плата пропущена.</translation>
    </message>
    <message>
        <source>thermometer</source>
        <translation>термометр</translation>
    </message>
    <message>
        <source>Only a file INPUT names its thermometer.</source>
        <translation>Термометр называет только файл INPUT.</translation>
    </message>
    <message>
        <source>The thermometer is named in the first line only.</source>
        <translation>Термометр называют только в первой строке.</translation>
    </message>
    <message>
        <source>%1 is not a code and a number, as in ~f01.</source>
        <translation>%1 — не код и номер, как в ~f01.</translation>
    </message>
    <message>
        <source>measured value</source>
        <translation>измеренное значение</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>температура</translation>
    </message>
    <message>
        <source>polynomial</source>
        <translation>полином</translation>
    </message>
    <message>
        <source>The value is not greater than the one in the line before.</source>
        <translation>Значение не больше, чем в предыдущей строке.</translation>
    </message>
    <message>
        <source>coefficient</source>
        <translation>коэффициент</translation>
    </message>
    <message>
        <source>%1 is not one of c0 … c9.</source>
        <translation>%1 — не один из c0 … c9.</translation>
    </message>
    <message>
        <source>The polynomial has no coefficients.</source>
        <translation>У полинома нет коэффициентов.</translation>
    </message>
    <message>
        <source>%1 stands in the file twice.</source>
        <translation>%1 есть в файле дважды.</translation>
    </message>
    <message>
        <source>Lines with a temperature and lines with c0, c1, … cannot stand in one file.</source>
        <translation>Строки с температурой и строки c0, c1, … не могут стоять в одном файле.</translation>
    </message>
    <message>
        <source>The parameter gets no values.</source>
        <translation>У параметра не будет значений.</translation>
    </message>
    <message>
        <source>input bit</source>
        <translation>входной бит</translation>
    </message>
    <message>
        <source>output bit of the blinker</source>
        <translation>выходной бит бленкера</translation>
    </message>
    <message>
        <source>minute of the check</source>
        <translation>минута проверки</translation>
    </message>
    <message>
        <source>sensitivity</source>
        <translation>чувствительность</translation>
    </message>
    <message>
        <source>background</source>
        <translation>фон</translation>
    </message>
    <message>
        <source>code</source>
        <translation>код</translation>
    </message>
    <message>
        <source>%1 is not a code: a Latin letter, with a number if need be.</source>
        <translation>%1 — не код: нужна латинская буква, при необходимости с номером.</translation>
    </message>
    <message>
        <source>The gamma sensor is left out.</source>
        <translation>Датчик гамма-излучения пропущен.</translation>
    </message>
    <message>
        <source>number</source>
        <translation>номер</translation>
    </message>
    <message>
        <source>period</source>
        <translation>период</translation>
    </message>
    <message>
        <source>port</source>
        <translation>порт</translation>
    </message>
    <message>
        <source>A port of the type “%1” cannot be used: no document says how its data look. Measure with another source.</source>
        <translation>Порт типа “%1” использовать нельзя: вид его данных нигде не описан. Измеряйте другим источником.</translation>
    </message>
    <message>
        <source>%1 is no port: it begins with one of the letters x, w, a, v, q.</source>
        <translation>%1 — не порт: он начинается с одной из букв x, w, a, v, q.</translation>
    </message>
    <message>
        <source>%1 is not the number of a port, 1 to 256.</source>
        <translation>%1 — не номер порта от 1 до 256.</translation>
    </message>
    <message>
        <source>The type letter has no port behind it: write its number, as in q1.</source>
        <translation>После буквы типа нет порта: напишите его номер, например q1.</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>скорость</translation>
    </message>
    <message>
        <source>data bits</source>
        <translation>биты данных</translation>
    </message>
    <message>
        <source>stop bits</source>
        <translation>стоповые биты</translation>
    </message>
    <message>
        <source>There are 1, 1.5 or 2 stop bits.</source>
        <translation>Стоповых битов бывает 1, 1.5 или 2.</translation>
    </message>
    <message>
        <source>parity</source>
        <translation>чётность</translation>
    </message>
    <message>
        <source>The parity is 0 (none), 1 (odd), 2 (even), 5 (mark) or 7 (space).</source>
        <translation>Чётность бывает 0 (нет), 1 (нечёт), 2 (чёт), 5 (единица) или 7 (ноль).</translation>
    </message>
    <message>
        <source>extra</source>
        <translation>дополнение</translation>
    </message>
    <message>
        <source>The object is left out.</source>
        <translation>Объект пропущен.</translation>
    </message>
    <message>
        <source>%1 is used in line %2.</source>
        <translation>%1 уже занят в строке %2.</translation>
    </message>
    <message>
        <source>averaging</source>
        <translation>осреднение</translation>
    </message>
    <message>
        <source>name</source>
        <translation>наименование</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>единица измерения</translation>
    </message>
    <message>
        <source>short name</source>
        <translation>условное имя</translation>
    </message>
    <message>
        <source>type</source>
        <translation>тип</translation>
    </message>
    <message>
        <source>format</source>
        <translation>формат</translation>
    </message>
    <message>
        <source>%1 is no format: write it as in %5.1f.</source>
        <translation>%1 — не формат: пишите его как %5.1f.</translation>
    </message>
    <message>
        <source>left limit</source>
        <translation>левая граница</translation>
    </message>
    <message>
        <source>right limit</source>
        <translation>правая граница</translation>
    </message>
    <message>
        <source>The right limit is less than the left one.</source>
        <translation>Правая граница меньше левой.</translation>
    </message>
    <message>
        <source>error</source>
        <translation>погрешность</translation>
    </message>
    <message>
        <source>x0</source>
        <translation>x0</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 — не число.</translation>
    </message>
    <message>
        <source>The parameter is left out.</source>
        <translation>Параметр пропущен.</translation>
    </message>
    <message>
        <source>The parameter %1 %2 stands in line %3 already.</source>
        <translation>Параметр %1 %2 уже есть в строке %3.</translation>
    </message>
    <message>
        <source>A station has at most %1 parameters.</source>
        <translation>У станции не больше %1 параметров.</translation>
    </message>
    <message>
        <source>%1 is not between %2 and %3.</source>
        <translation>%1 — не между %2 и %3.</translation>
    </message>
    <message>
        <source>The text has no closing double quote.</source>
        <translation>У текста нет закрывающей кавычки.</translation>
    </message>
    <message>
        <source>The field is missing.</source>
        <translation>Поля нет.</translation>
    </message>
    <message>
        <source>%1 is not a whole number.</source>
        <translation>%1 — не целое число.</translation>
    </message>
    <message>
        <source>%1 is not one Latin letter.</source>
        <translation>%1 — не одна латинская буква.</translation>
    </message>
    <message>
        <source>A polynomial has at most %1 coefficients.</source>
        <translation>У полинома не больше %1 коэффициентов.</translation>
    </message>
    <message>
        <source>The file has %1 of %2 values.</source>
        <translation>В файле %1 из %2 значений.</translation>
    </message>
    <message>
        <source>The usual ones are used for the others.</source>
        <translation>Для остальных берутся обычные.</translation>
    </message>
    <message>
        <source>number of the station</source>
        <translation>номер станции</translation>
    </message>
    <message>
        <source>calculation of σ</source>
        <translation>расчёт σ</translation>
    </message>
    <message>
        <source>hold of the maximum, ticks</source>
        <translation>удержание максимума, тики</translation>
    </message>
    <message>
        <source>shift of the request, s</source>
        <translation>сдвиг запроса, с</translation>
    </message>
    <message>
        <source>copies in SAFE</source>
        <translation>копии в SAFE</translation>
    </message>
    <message>
        <source>number of attempts</source>
        <translation>количество попыток</translation>
    </message>
    <message>
        <source>averaging of frequency, ticks</source>
        <translation>осреднение частоты, тики</translation>
    </message>
    <message>
        <source>calibration time, s</source>
        <translation>время калибровки, с</translation>
    </message>
    <message>
        <source>averaging, s</source>
        <translation>осреднение, с</translation>
    </message>
    <message>
        <source>percent of good values</source>
        <translation>процент хороших значений</translation>
    </message>
    <message>
        <source>no protocol file</source>
        <translation>запрет файла протокола</translation>
    </message>
    <message>
        <source>watchdog, s</source>
        <translation>сторожевой таймер, с</translation>
    </message>
    <message>
        <source>pulse filter, µs</source>
        <translation>фильтр импульсов, мкс</translation>
    </message>
    <message>
        <source>The values %1 are without effect here.</source>
        <translation>Значения %1 здесь не действуют.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>строка %1</translation>
    </message>
    <message>
        <source>field %1</source>
        <translation>поле %1</translation>
    </message>
    <message>
        <source>… and %1 more.</source>
        <translation>… и ещё %1.</translation>
    </message>
    <message>
        <source>The file cannot be read (%1).</source>
        <translation>Файл не читается (%1).</translation>
    </message>
    <message>
        <source>The file is longer than 1 MiB.</source>
        <translation>Файл длиннее 1 МиБ.</translation>
    </message>
    <message>
        <source>The folder does not exist.</source>
        <translation>Папки нет.</translation>
    </message>
    <message>
        <source>The file is not used.</source>
        <translation>Файл не используется.</translation>
    </message>
    <message>
        <source>Another file of the folder is %1 already.</source>
        <translation>В папке уже есть другой файл %1.</translation>
    </message>
    <message>
        <source>ACK.PAR has no parameter %1.</source>
        <translation>В ACK.PAR нет параметра %1.</translation>
    </message>
    <message>
        <source>The file is missing.</source>
        <translation>Файла нет.</translation>
    </message>
    <message>
        <source>The usual settings are used.</source>
        <translation>Берутся обычные настройки.</translation>
    </message>
    <message>
        <source>The station has neither sources nor lines.</source>
        <translation>У станции нет ни источников, ни линий.</translation>
    </message>
    <message>
        <source>The station has no parameters.</source>
        <translation>У станции нет параметров.</translation>
    </message>
    <message>
        <source>ACK.PAR has no thermometer, a parameter with the code T.</source>
        <translation>В ACK.PAR нет термометра — параметра с кодом T.</translation>
    </message>
    <message>
        <source>Nothing is added.</source>
        <translation>Ничего не прибавляется.</translation>
    </message>
    <message>
        <source>The source needs the file %1.</source>
        <translation>Источнику нужен файл %1.</translation>
    </message>
    <message>
        <source>It measures nothing.</source>
        <translation>Он ничего не измеряет.</translation>
    </message>
    <message>
        <source>The object that gathers has the number %1 and the station, by ACK.PSE, %2.</source>
        <translation>Номер собирающего объекта — %1, а станции по ACK.PSE — %2.</translation>
    </message>
    <message>
        <source>It gathers all the same.</source>
        <translation>Он всё равно собирает.</translation>
    </message>
    <message>
        <source>Its input is not used.</source>
        <translation>Его вход не используется.</translation>
    </message>
    <message>
        <source>Nothing is measured.</source>
        <translation>Ничего не измеряется.</translation>
    </message>
</context>
<context>
    <name>StatusBits</name>
    <message>
        <source>polling is off</source>
        <translation>опрос отключен</translation>
    </message>
    <message>
        <source>angles are not valid or not ready</source>
        <translation>результаты измерения углов наклона не достоверны или не готовы</translation>
    </message>
    <message>
        <source>temperature is not valid or not ready</source>
        <translation>результаты измерения температуры не достоверны или не готовы</translation>
    </message>
    <message>
        <source>accelerations are not valid or not ready</source>
        <translation>результаты измерения ускорений не достоверны или не готовы</translation>
    </message>
    <message>
        <source>the exchange buffer of accelerations overran</source>
        <translation>переполнение буфера обмена ускорений</translation>
    </message>
    <message>
        <source>synchronisation error</source>
        <translation>ошибка синхронизации</translation>
    </message>
    <message>
        <source>the microcontroller has restarted</source>
        <translation>произошла перезагрузка микроконтроллера</translation>
    </message>
    <message>
        <source>the thermostat has not settled</source>
        <translation>терморегулирование не завершено</translation>
    </message>
    <message>
        <source>heating of the thermostat at minimum (fast cooling)</source>
        <translation>минимальная мощность нагрева термостата (быстрое охлаждение)</translation>
    </message>
    <message>
        <source>heating of the thermostat at maximum (fast heating)</source>
        <translation>максимальная мощность нагрева термостата (быстрый нагрев)</translation>
    </message>
    <message>
        <source>the thermostat is on</source>
        <translation>термостат включен</translation>
    </message>
    <message>
        <source>searching for its address</source>
        <translation>поиск адреса</translation>
    </message>
    <message>
        <source>error of the thermostat</source>
        <translation>ошибка термостата</translation>
    </message>
    <message>
        <source>error of the fan</source>
        <translation>ошибка вентилятора</translation>
    </message>
    <message>
        <source>temperature out of range</source>
        <translation>температура вне диапазона</translation>
    </message>
    <message>
        <source>temperature cannot be read</source>
        <translation>ошибка чтения температуры</translation>
    </message>
    <message>
        <source>the transducer is out of range</source>
        <translation>первичный преобразователь вне диапазона</translation>
    </message>
    <message>
        <source>CRC errors of the transducer</source>
        <translation>ошибки CRC первичного преобразователя</translation>
    </message>
    <message>
        <source>the transducer does not answer</source>
        <translation>первичный преобразователь не отвечает</translation>
    </message>
    <message>
        <source>data of the fan are ready</source>
        <translation>данные вентилятора готовы</translation>
    </message>
    <message>
        <source>temperature is ready</source>
        <translation>температура готова</translation>
    </message>
    <message>
        <source>angles are ready</source>
        <translation>углы готовы</translation>
    </message>
    <message>
        <source>the restart was acknowledged</source>
        <translation>перезагрузка подтверждена</translation>
    </message>
    <message>
        <source>bit %1: %2</source>
        <translation>бит %1: %2</translation>
    </message>
    <message>
        <source>code %1: %2</source>
        <translation>код %1: %2</translation>
    </message>
    <message>
        <source>Status word of the sensor: the code of the error, then bits 11…0</source>
        <translation>Слово состояния датчика: код ошибки, затем биты 11…0</translation>
    </message>
    <message>
        <source>bits 11 and 10 do not count: the sensor has no thermostat</source>
        <translation>биты 11 и 10 не учитываются: у датчика нет термостата</translation>
    </message>
    <message>
        <source>mode, bit 6: the recording of accelerations is stopped</source>
        <translation>режим, бит 6: запись ускорений остановлена</translation>
    </message>
</context>
<context>
    <name>UsmIsnDriver</name>
    <message>
        <source>A device of type %1 answers, not an УСМ-ИСН (28); it is not polled. Check the address.</source>
        <translation>Отвечает устройство типа %1, а не УСМ-ИСН (28); оно не опрашивается. Проверьте адрес.</translation>
    </message>
    <message>
        <source>The device has no channel for one of its axes (ErrorCH). Check the address.</source>
        <translation>У устройства нет канала одной из осей (ErrorCH). Проверьте адрес.</translation>
    </message>
    <message>
        <source>The device does not understand the request (ErrorData).</source>
        <translation>Устройство не понимает запрос (ErrorData).</translation>
    </message>
</context>
<context>
    <name>VibrationPage</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>code %1</source>
        <translation>код %1</translation>
    </message>
    <message>
        <source>%1: type %2 %3</source>
        <translation>%1: тип %2 %3</translation>
    </message>
    <message>
        <source>baseline %1</source>
        <translation>базовый уровень %1</translation>
    </message>
    <message>
        <source>enabled</source>
        <translation>разрешено</translation>
    </message>
    <message>
        <source>off</source>
        <translation>отключено</translation>
    </message>
    <message>
        <source>logical %1</source>
        <translation>логическое %1</translation>
    </message>
    <message>
        <source>physical %1</source>
        <translation>физическое %1</translation>
    </message>
    <message>
        <source>error</source>
        <translation>ошибка</translation>
    </message>
    <message>
        <source>Channel %1</source>
        <translation>Канал %1</translation>
    </message>
    <message>
        <source>State of the channel</source>
        <translation>Состояние канала</translation>
    </message>
    <message>
        <source>state of the line to the sensor of the channel</source>
        <translation>состояние линии датчика этого канала</translation>
    </message>
    <message>
        <source>value; share of the scale; what is raised (with a question mark: the module does not know it); the baseline, if it is valid</source>
        <translation>значение; доля шкалы; что сработало (с вопросительным знаком — модуль этого не знает); базовый уровень, если он достоверен</translation>
    </message>
    <message>
        <source>Relays</source>
        <translation>Реле</translation>
    </message>
    <message>
        <source>Relay %1</source>
        <translation>Реле %1</translation>
    </message>
    <message>
        <source>what the module has decided (logical), what its output shows (physical)</source>
        <translation>что решил модуль (логическое), что на его выходе (физическое)</translation>
    </message>
    <message>
        <source>channel %1: %2</source>
        <translation>канал %1: %2</translation>
    </message>
</context>
<context>
    <name>WeatherRows</name>
    <message>
        <source>Gathered since the program started, over the chosen time</source>
        <translation>Собрано с запуска программы за выбранное время</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>Отсчётов</translation>
    </message>
    <message>
        <source>how many readings of the wind the rose consists of</source>
        <translation>из скольких показаний ветра состоит роза</translation>
    </message>
    <message>
        <source>Prevailing direction</source>
        <translation>Преобладает направление</translation>
    </message>
    <message>
        <source>the rumb from which the wind blew most often, and its share of all readings</source>
        <translation>румб, откуда ветер дул чаще всего, и его доля во всех показаниях</translation>
    </message>
    <message>
        <source>Mean speed, m/s</source>
        <translation>Средняя скорость, м/с</translation>
    </message>
    <message>
        <source>mean of the mean speeds</source>
        <translation>среднее из средних скоростей</translation>
    </message>
    <message>
        <source>Strongest gust, m/s</source>
        <translation>Наибольший порыв, м/с</translation>
    </message>
    <message>
        <source>the largest speed that the station reported</source>
        <translation>наибольшая скорость, о которой сообщила станция</translation>
    </message>
    <message>
        <source>Calm, %</source>
        <translation>Штиль, %</translation>
    </message>
    <message>
        <source>share of the readings below %1 m/s</source>
        <translation>доля показаний меньше %1 м/с</translation>
    </message>
    <message>
        <source>Without direction, %</source>
        <translation>Без направления, %</translation>
    </message>
    <message>
        <source>share of the readings whose speed is valid and whose direction is not</source>
        <translation>доля показаний, скорость которых достоверна, а направление нет</translation>
    </message>
    <message>
        <source>mean value (instantaneous value | minimum … maximum), as far as the station gives them</source>
        <translation>среднее значение (мгновенное | минимум … максимум), если станция их передаёт</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Цифровые входы</translation>
    </message>
    <message>
        <source>the word of the inputs, and the numbers of those that are on; the first one is 0</source>
        <translation>слово входов и номера включённых; первый вход — 0</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Направление</translation>
    </message>
    <message>
        <source>from where it blows, mean: degrees from the north clockwise, and the rumb</source>
        <translation>откуда дует, среднее: градусы от севера по часовой стрелке и румб</translation>
    </message>
    <message>
        <source>Direction now</source>
        <translation>Направление сейчас</translation>
    </message>
    <message>
        <source>from where it blows at this moment</source>
        <translation>откуда дует в этот момент</translation>
    </message>
    <message>
        <source>Speed, m/s</source>
        <translation>Скорость, м/с</translation>
    </message>
    <message>
        <source>mean of the modulus over the averaging interval of the station</source>
        <translation>среднее модуля за интервал осреднения станции</translation>
    </message>
    <message>
        <source>Speed now, m/s</source>
        <translation>Скорость сейчас, м/с</translation>
    </message>
    <message>
        <source>speed of the last seconds</source>
        <translation>скорость последних секунд</translation>
    </message>
    <message>
        <source>Gust, m/s</source>
        <translation>Порыв, м/с</translation>
    </message>
    <message>
        <source>maximum over the averaging interval of the station</source>
        <translation>максимум за интервал осреднения станции</translation>
    </message>
    <message>
        <source>Gust since the last request, m/s</source>
        <translation>Порыв с прошлого запроса, м/с</translation>
    </message>
    <message>
        <source>maximum since the station was asked before</source>
        <translation>максимум с предыдущего запроса станции</translation>
    </message>
    <message>
        <source>σ of the direction, °</source>
        <translation>σ направления, °</translation>
    </message>
    <message>
        <source>root mean square deviation of the direction</source>
        <translation>среднеквадратическое отклонение направления</translation>
    </message>
    <message>
        <source>σ of the speed, m/s</source>
        <translation>σ скорости, м/с</translation>
    </message>
    <message>
        <source>root mean square deviation of the speed</source>
        <translation>среднеквадратическое отклонение скорости</translation>
    </message>
    <message>
        <source>U, V, m/s</source>
        <translation>U, V, м/с</translation>
    </message>
    <message>
        <source>components of the mean wind: U &gt; 0 blows towards the east, V &gt; 0 towards the north</source>
        <translation>составляющие среднего ветра: U &gt; 0 — дует на восток, V &gt; 0 — на север</translation>
    </message>
</context>
<context>
    <name>WeatherText</name>
    <message>
        <source>N</source>
        <translation>С</translation>
    </message>
    <message>
        <source>NNE</source>
        <translation>ССВ</translation>
    </message>
    <message>
        <source>NE</source>
        <translation>СВ</translation>
    </message>
    <message>
        <source>ENE</source>
        <translation>ВСВ</translation>
    </message>
    <message>
        <source>E</source>
        <translation>В</translation>
    </message>
    <message>
        <source>ESE</source>
        <translation>ВЮВ</translation>
    </message>
    <message>
        <source>SE</source>
        <translation>ЮВ</translation>
    </message>
    <message>
        <source>SSE</source>
        <translation>ЮЮВ</translation>
    </message>
    <message>
        <source>S</source>
        <translation>Ю</translation>
    </message>
    <message>
        <source>SSW</source>
        <translation>ЮЮЗ</translation>
    </message>
    <message>
        <source>SW</source>
        <translation>ЮЗ</translation>
    </message>
    <message>
        <source>WSW</source>
        <translation>ЗЮЗ</translation>
    </message>
    <message>
        <source>W</source>
        <translation>З</translation>
    </message>
    <message>
        <source>WNW</source>
        <translation>ЗСЗ</translation>
    </message>
    <message>
        <source>NW</source>
        <translation>СЗ</translation>
    </message>
    <message>
        <source>NNW</source>
        <translation>ССЗ</translation>
    </message>
    <message>
        <source>none is on</source>
        <translation>ни один не включён</translation>
    </message>
    <message>
        <source>wind %1 %2</source>
        <translation>ветер %1 %2</translation>
    </message>
    <message>
        <source>temperature %1 %2</source>
        <translation>температура %1 %2</translation>
    </message>
</context>
<context>
    <name>WindowPages</name>
    <message>
        <source>Trends</source>
        <translation>Графики</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Перемещения</translation>
    </message>
    <message>
        <source>History</source>
        <translation>История</translation>
    </message>
    <message>
        <source>Hodograph</source>
        <translation>Годограф</translation>
    </message>
    <message>
        <source>Oscillations</source>
        <translation>Колебания</translation>
    </message>
    <message>
        <source>Weather</source>
        <translation>Погода</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Вибрация</translation>
    </message>
</context>
<context>
    <name>gorizont::Acquisition</name>
    <message>
        <source>there is no folder %1</source>
        <translation>нет папки %1</translation>
    </message>
    <message>
        <source>another program runs the station in %1</source>
        <translation>станция из папки %1 уже работает в другой программе</translation>
    </message>
</context>
<context>
    <name>gorizont::AlarmWatch</name>
    <message numerus="yes">
        <source>Accepted by the dispatcher: %n message(s)</source>
        <translation>
            <numerusform>Принято диспетчером: %n сообщение</numerusform>
            <numerusform>Принято диспетчером: %n сообщения</numerusform>
            <numerusform>Принято диспетчером: %n сообщений</numerusform>
        </translation>
    </message>
    <message>
        <source>Accepted by the dispatcher: %1</source>
        <translation>Принято диспетчером: %1</translation>
    </message>
</context>
<context>
    <name>gorizont::And3Dialog</name>
    <message>
        <source>Nothing was written that needs a reset. Restart sensor %1? Its memory of samples is lost.</source>
        <translation>Сброс не требуется: ничего не записано. Перезапустить датчик %1? Накопленные в нём измерения будут потеряны.</translation>
    </message>
    <message>
        <source>&amp;Restart</source>
        <translation>&amp;Перезапустить</translation>
    </message>
    <message>
        <source>Sensor %1 restarts with its new address %2; nobody has seen it there yet. Leave all the same?</source>
        <translation>Датчик %1 перезапускается с новым адресом %2, но ещё не проверено, что он отвечает. Всё равно выйти?</translation>
    </message>
    <message>
        <source>The new address %2 of sensor %1 is stored, but it holds only after a system reset. Leave without it?</source>
        <translation>Новый адрес %2 датчика %1 записан, но вступит в силу только после сброса системы. Выйти без сброса?</translation>
    </message>
    <message>
        <source>Reading sensor %1…</source>
        <translation>Чтение параметров датчика %1…</translation>
    </message>
    <message>
        <source>Sensor %1 cannot be read: %2.</source>
        <translation>Параметры датчика %1 не прочитаны: %2.</translation>
    </message>
    <message>
        <source>new address %1</source>
        <translation>новый адрес %1</translation>
    </message>
    <message>
        <source>Writing: %1…</source>
        <translation>Запись: %1…</translation>
    </message>
    <message>
        <source>new address %1 stored, it holds after a system reset</source>
        <translation>новый адрес %1 записан, вступит в силу после сброса системы</translation>
    </message>
    <message>
        <source>Sensor %1: %2</source>
        <translation>Датчик %1: %2</translation>
    </message>
    <message>
        <source>The new address %1 is stored in the sensor. Press &lt;System reset&gt; so that the sensor takes it.</source>
        <translation>Новый адрес %1 записан в датчик. Чтобы он вступил в силу, нажмите &lt;Сброс системы&gt;.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>ОК</translation>
    </message>
    <message>
        <source>system reset</source>
        <translation>сброс системы</translation>
    </message>
    <message>
        <source>The sensor restarts…</source>
        <translation>Датчик перезапускается…</translation>
    </message>
    <message>
        <source>system reset sent</source>
        <translation>команда сброса системы отправлена</translation>
    </message>
    <message>
        <source>system reset not sent: %1</source>
        <translation>команда сброса системы не отправлена: %1</translation>
    </message>
    <message>
        <source>the sensor answers at its new address %1</source>
        <translation>датчик отвечает по новому адресу %1</translation>
    </message>
    <message>
        <source>the sensor still answers at its old address after the reset. Write the new one again.</source>
        <translation>после сброса датчик отвечает по прежнему адресу. Запишите новый адрес ещё раз.</translation>
    </message>
    <message>
        <source>the sensor answers neither at %1 nor at %2 after the reset. Scan again; check its power.</source>
        <translation>после сброса датчик не отвечает ни по адресу %1, ни по адресу %2. Повторите сканирование, проверьте питание.</translation>
    </message>
</context>
<context>
    <name>gorizont::And3Form</name>
    <message>
        <source>Exchange</source>
        <translation>Параметры обмена</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Изменить</translation>
    </message>
    <message>
        <source>The address of %1 is changed in the group &lt;System&gt;.</source>
        <translation>Адрес %1 изменяется в группе &lt;Система&gt;.</translation>
    </message>
    <message>
        <source>&amp;Address on the line:</source>
        <translation>&amp;Адрес на линии:</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Данные</translation>
    </message>
    <message>
        <source>Temperature, °C:</source>
        <translation>Температура, °C:</translation>
    </message>
    <message>
        <source>Tilt X, Y, ″:</source>
        <translation>Наклон X, Y, ″:</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Система</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>За&amp;пись</translation>
    </message>
    <message>
        <source>System &amp;reset</source>
        <translation>Сброс с&amp;истемы</translation>
    </message>
    <message>
        <source>Restarts the controller of the sensor, about five seconds. Its memory of samples is lost.</source>
        <translation>Перезапускает контроллер датчика, около пяти секунд. Накопленные в датчике измерения теряются.</translation>
    </message>
    <message>
        <source>Set a &amp;new address:</source>
        <translation>За&amp;дать новый адр.:</translation>
    </message>
    <message>
        <source>Current address:</source>
        <translation>Текущий адрес:</translation>
    </message>
    <message>
        <source>Firmware:</source>
        <translation>Версия ПО:</translation>
    </message>
    <message>
        <source>Addresses where nobody answered</source>
        <translation>Адреса, по которым никто не ответил</translation>
    </message>
    <message>
        <source>The address can be changed only after a complete scan that was not stopped.</source>
        <translation>Изменить адрес можно только после полного сканирования, без остановки.</translation>
    </message>
</context>
<context>
    <name>gorizont::Application</name>
    <message>
        <source>Gorizont Server %1 started</source>
        <translation>Gorizont Server %1 запущен</translation>
    </message>
    <message>
        <source>Another copy of the program writes into %1: this copy does not save. Give it a folder of its own.</source>
        <translation>В %1 пишет другая копия программы: эта копия не сохраняет. Задайте ей отдельную папку.</translation>
    </message>
    <message>
        <source>Modbus TCP: port %1</source>
        <translation>Modbus TCP: порт %1</translation>
    </message>
    <message>
        <source>Modbus TCP: port %1 cannot be used</source>
        <translation>Modbus TCP: порт %1 недоступен</translation>
    </message>
    <message>
        <source>Modbus TCP: off</source>
        <translation>Modbus TCP: выключен</translation>
    </message>
    <message>
        <source>Gorizont Server ended</source>
        <translation>Gorizont Server завершён</translation>
    </message>
    <message>
        <source>Another copy of the program sends from %1 to the MQTT broker: this copy does not send.</source>
        <translation>Из папки %1 брокеру MQTT передаёт другая копия программы: эта копия не передаёт.</translation>
    </message>
    <message>
        <source>MQTT: connected</source>
        <translation>MQTT: соединение есть</translation>
    </message>
    <message>
        <source>MQTT: no broker, readings waiting: %1</source>
        <translation>MQTT: брокера нет, ждут показаний: %1</translation>
    </message>
</context>
<context>
    <name>gorizont::ArchiveDatabase</name>
    <message>
        <source>The folder %1 cannot be created. Check the rights and the name.</source>
        <translation>Не удаётся создать папку %1. Проверьте права доступа и имя.</translation>
    </message>
    <message>
        <source>%1 was written by a newer version of the program. Install that one, or name another file.</source>
        <translation>%1 записан более новой версией программы. Установите её или укажите другой файл.</translation>
    </message>
    <message>
        <source>%1 holds no archive.</source>
        <translation>В файле %1 нет архива.</translation>
    </message>
    <message>
        <source>%1 is in use by another program. Close that program.</source>
        <translation>%1 занят другой программой. Закройте её.</translation>
    </message>
    <message>
        <source>There is no room left for %1. Free some on that disk.</source>
        <translation>Для %1 не осталось места. Освободите место на этом диске.</translation>
    </message>
    <message>
        <source>%1 is damaged.</source>
        <translation>%1 повреждён.</translation>
    </message>
    <message>
        <source>%1 cannot be opened for writing. Check the rights and the name.</source>
        <translation>Не удаётся открыть %1 для записи. Проверьте права доступа и имя.</translation>
    </message>
    <message>
        <source>%1 does not answer. Check the server and the network.</source>
        <translation>%1 не отвечает. Проверьте сервер и сеть.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The driver for PostgreSQL is missing. Install libqt6sql6-psql.</source>
        <translation>Нет драйвера PostgreSQL. Установите пакет libqt6sql6-psql.</translation>
    </message>
    <message>
        <source>%1 refuses: %2. Check User, PasswordFile and Database of [Archive].</source>
        <translation>%1 отказывает: %2. Проверьте User, PasswordFile и Database в [Archive].</translation>
    </message>
</context>
<context>
    <name>gorizont::ArchiveRecorder</name>
    <message>
        <source>Another copy of the program writes into %1. Close it, or name another file.</source>
        <translation>В %1 пишет другая копия программы. Закройте её или укажите другой файл.</translation>
    </message>
    <message>
        <source>%1 cannot be opened for writing. Check the rights and the name.</source>
        <translation>Не удаётся открыть %1 для записи. Проверьте права доступа и имя.</translation>
    </message>
    <message>
        <source>A part of the archive of about a second is damaged and left out.</source>
        <translation>Часть архива длиной около секунды повреждена и пропущена.</translation>
    </message>
    <message>
        <source>The archive could not be written for too long: readings of %1 sensors, %2 blocks of samples and %3 events are not in it.</source>
        <translation>Архив слишком долго не удавалось записать: в него не попали показания датчиков (%1), блоки отсчётов (%2) и события (%3).</translation>
    </message>
    <message>
        <source>What could be read of the damaged archive is in the new one: %1 rows.</source>
        <translation>Всё, что удалось прочесть из повреждённого архива, перенесено в новый: строк — %1.</translation>
    </message>
    <message>
        <source>%1 is damaged: a part of what was measured while the server of the archive was gone is left out.</source>
        <translation>Файл %1 повреждён: часть измеренного за время, пока сервер архива был недоступен, пропущена.</translation>
    </message>
    <message>
        <source>What is measured while the server of the archive is gone cannot be kept: %1. Free some room there.</source>
        <translation>Измеренное, пока сервер архива недоступен, сохранить нельзя: %1. Освободите там место.</translation>
    </message>
    <message>
        <source>The archive could not be written for too long: records that sensors had kept are not in it. Read them again.</source>
        <translation>Архив слишком долго не удавалось записать: записей, которые хранили датчики, в нём нет. Считайте их ещё раз.</translation>
    </message>
    <message>
        <source>Rollups of the archive were damaged, %1 of them. They were made again from the readings that are still there.</source>
        <translation>В архиве были повреждены сводки: %1. Они построены заново по сохранившимся показаниям.</translation>
    </message>
    <message>
        <source>%1 cannot be read. Check that disk.</source>
        <translation>%1 не читается. Проверьте этот диск.</translation>
    </message>
</context>
<context>
    <name>gorizont::ArchiveWriter</name>
    <message>
        <source>The archive %1 is damaged. It was set aside as %2, and recording goes on in a new file.</source>
        <translation>Архив %1 повреждён. Он отложен под именем %2, запись продолжается в новый файл.</translation>
    </message>
    <message>
        <source>The archive is not being written: %1 It is tried again every few seconds.</source>
        <translation>Архив не записывается: %1 Попытки повторяются каждые несколько секунд.</translation>
    </message>
    <message>
        <source>The archive is being written again.</source>
        <translation>Архив снова записывается.</translation>
    </message>
    <message>
        <source>The archive is not being written: %1 Until it is, what is measured waits in %2.</source>
        <translation>Архив не записывается: %1 До тех пор измеренное ждёт в %2.</translation>
    </message>
    <message>
        <source>What is too old cannot be removed from the archive: %1 It is tried again every few minutes.</source>
        <translation>Устаревшие данные не удаляются из архива: %1 Попытки повторяются каждые несколько минут.</translation>
    </message>
    <message>
        <source>What is too old is removed from the archive again.</source>
        <translation>Устаревшие данные снова удаляются из архива.</translation>
    </message>
</context>
<context>
    <name>gorizont::AttentionBanner</name>
    <message>
        <source>Show</source>
        <translation>Показать</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Принять</translation>
    </message>
    <message>
        <source>The messages are known: they leave the list, the sensors stay marked until they work again</source>
        <translation>Сообщения приняты к сведению: они уходят из списка, а датчики остаются отмеченными, пока не заработают</translation>
    </message>
    <message>
        <source>%1. The newest message: %2</source>
        <translation>%1. Последнее сообщение: %2</translation>
    </message>
</context>
<context>
    <name>gorizont::AttentionDialog</name>
    <message>
        <source>Messages for the dispatcher</source>
        <translation>Сообщения для диспетчера</translation>
    </message>
    <message>
        <source>&amp;Accept</source>
        <translation>&amp;Принять</translation>
    </message>
    <message>
        <source>Accept a&amp;ll</source>
        <translation>Принять &amp;все</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Закрыть</translation>
    </message>
    <message>
        <source>There are no messages</source>
        <translation>Сообщений нет</translation>
    </message>
    <message>
        <source>accepted, not mended yet: %1</source>
        <translation>принято, но ещё не устранено: %1</translation>
    </message>
</context>
<context>
    <name>gorizont::AttentionModel</name>
    <message>
        <source>Since</source>
        <translation>Возникло</translation>
    </message>
    <message>
        <source>Sensor or port</source>
        <translation>Датчик или порт</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Место установки</translation>
    </message>
    <message>
        <source>What has happened</source>
        <translation>Что произошло</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Что делать</translation>
    </message>
</context>
<context>
    <name>gorizont::CaptureFolder</name>
    <message>
        <source>A capture of an L-VIMS is lost, it could not be saved: %1. So will be those that follow, until there is room for them.</source>
        <translation>Захват L-VIMS потерян, сохранить его не удалось: %1. Следующие будут потеряны тоже, пока для них не найдётся места.</translation>
    </message>
    <message>
        <source>The captures of the L-VIMS are being saved again.</source>
        <translation>Захваты L-VIMS снова сохраняются.</translation>
    </message>
</context>
<context>
    <name>gorizont::CaptureText</name>
    <message>
        <source>waveform</source>
        <translation>выборка</translation>
    </message>
    <message>
        <source>spectrum up to 5000 Hz</source>
        <translation>спектр до 5000 Гц</translation>
    </message>
    <message>
        <source>spectrum up to 200 Hz</source>
        <translation>спектр до 200 Гц</translation>
    </message>
    <message>
        <source>Waiting for the %1…</source>
        <translation>Ожидание: %1…</translation>
    </message>
    <message>
        <source>Fetching the %1: %2 of %3</source>
        <translation>Чтение: %1, %2 из %3</translation>
    </message>
    <message>
        <source>There is no data on this channel (%1). Look whether the channel measures and its sensor is connected.</source>
        <translation>По этому каналу нет данных (%1). Проверьте, включён ли канал и подключён ли датчик.</translation>
    </message>
    <message>
        <source>The module answers and does not finish the %1. Try again, or restart the module.</source>
        <translation>Модуль отвечает, но не завершает операцию: %1. Повторите или перезапустите модуль.</translation>
    </message>
    <message>
        <source>The module does not answer (%1). Check its power and its network cable.</source>
        <translation>Модуль не отвечает (%1). Проверьте питание и сетевой кабель.</translation>
    </message>
    <message>
        <source>The module refuses the %1 (exception %2 of Modbus). The channel may have no data, or another program let the module keep a new one: try again.</source>
        <translation>Модуль отказал: %1 (исключение Modbus %2). Возможно, по каналу нет данных или другая программа зафиксировала новую выборку: повторите.</translation>
    </message>
    <message>
        <source>Another client has changed the selection of the module %1 times while the %2 was read. Stop its reading, or try again.</source>
        <translation>Другой клиент %1 раза менял выбор в модуле во время чтения (%2). Остановите его чтение или повторите.</translation>
    </message>
    <message>
        <source>What the module says of the %1 makes no sense. Try again.</source>
        <translation>Сведения модуля не имеют смысла: %1. Повторите.</translation>
    </message>
    <message>
        <source>The answers are damaged (%1). Try again.</source>
        <translation>Ответы повреждены (%1). Повторите.</translation>
    </message>
    <message>
        <source>The port is gone or in service (%1). Capture again when it is back.</source>
        <translation>Порт пропал или обслуживается (%1). Снимите снова, когда он вернётся.</translation>
    </message>
    <message>
        <source>Broken off (%1).</source>
        <translation>Прервано (%1).</translation>
    </message>
    <message>
        <source>The port is in service; nothing is captured until that ends.</source>
        <translation>Порт обслуживается; до конца обслуживания ничего не снимается.</translation>
    </message>
    <message>
        <source>The module is away: its port is not open. Check its power and its network cable.</source>
        <translation>Модуля нет: порт не открыт. Проверьте питание и сетевой кабель.</translation>
    </message>
    <message>
        <source>Channel %1 is switched off in the settings of the module.</source>
        <translation>Канал %1 выключен в настройках модуля.</translation>
    </message>
    <message>
        <source>Channel %1: the line of the sensor is shorted. Check its cable.</source>
        <translation>Канал %1: короткое замыкание линии датчика. Проверьте кабель.</translation>
    </message>
    <message>
        <source>Channel %1: the line of the sensor is broken. Check its cable.</source>
        <translation>Канал %1: обрыв линии датчика. Проверьте кабель.</translation>
    </message>
    <message>
        <source>Channel %1 has no data yet.</source>
        <translation>По каналу %1 ещё нет данных.</translation>
    </message>
    <message>
        <source>Channel %1 is in state %2.</source>
        <translation>Канал %1 в состоянии %2.</translation>
    </message>
    <message>
        <source>%1 Hz (%2)</source>
        <translation>%1 Гц (%2)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>gorizont::ChangeText</name>
    <message>
        <source>the new address %1 is taken; nothing was stored. Scan again.</source>
        <translation>новый адрес %1 занят; ничего не записано. Повторите сканирование.</translation>
    </message>
    <message>
        <source>asking the sensor before the change failed (%1); nothing was stored</source>
        <translation>проверка датчика перед изменением не удалась (%1); ничего не записано</translation>
    </message>
    <message>
        <source>copying the configuration failed (%1); nothing was stored</source>
        <translation>копирование конфигурации не удалось (%1); ничего не записано</translation>
    </message>
    <message>
        <source>checking the copied configuration failed (%1); nothing was stored</source>
        <translation>проверка копии конфигурации не удалась (%1); ничего не записано</translation>
    </message>
    <message>
        <source>setting the new address %2 failed (%1); nothing was stored</source>
        <translation>установка нового адреса %2 не удалась (%1); ничего не записано</translation>
    </message>
    <message>
        <source>checking the new address %2 failed (%1); nothing was stored</source>
        <translation>проверка нового адреса %2 не удалась (%1); ничего не записано</translation>
    </message>
    <message>
        <source>name “%1”</source>
        <translation>имя «%1»</translation>
    </message>
    <message>
        <source>zero offset X %1″, Y %2″</source>
        <translation>смещение нуля X %1″, Y %2″</translation>
    </message>
    <message>
        <source>averaging ticks %1</source>
        <translation>тактов усреднения %1</translation>
    </message>
    <message>
        <source>averaging period %1 ms</source>
        <translation>период усреднения %1 мс</translation>
    </message>
    <message>
        <source>written</source>
        <translation>записано</translation>
    </message>
    <message>
        <source>not written, the sensor does not take it</source>
        <translation>не записано, датчик не принимает значение</translation>
    </message>
    <message>
        <source>not written, the sensor still has another value</source>
        <translation>не записано, в датчике осталось другое значение</translation>
    </message>
    <message>
        <source>%1: whether it was written is not known, check it</source>
        <translation>%1: записано или нет, неизвестно, проверьте</translation>
    </message>
    <message>
        <source>storing the new address %2 failed (%1); whether it was stored is not known. Write again before a reset.</source>
        <translation>запись нового адреса %2 не удалась (%1); записан ли он, неизвестно. Повторите запись до сброса.</translation>
    </message>
    <message>
        <source>the new address %2 was stored, but checking the stored configuration failed (%1). Write again before a reset.</source>
        <translation>новый адрес %2 записан, но проверка записанной конфигурации не удалась (%1). Повторите запись до сброса.</translation>
    </message>
</context>
<context>
    <name>gorizont::ClientModel</name>
    <message>
        <source>What the client is connected to</source>
        <translation>К чему подключён клиент</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Сервер</translation>
    </message>
    <message>
        <source>Address and port of the client</source>
        <translation>Адрес и порт клиента</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Клиент</translation>
    </message>
    <message>
        <source>When the client connected</source>
        <translation>Когда клиент подключился</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Подключён</translation>
    </message>
    <message>
        <source>Requests answered</source>
        <translation>Запросов, на которые отвечено</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Запросов</translation>
    </message>
    <message>
        <source>How long ago the last request came</source>
        <translation>Сколько времени назад был последний запрос</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Последний</translation>
    </message>
    <message>
        <source>Requests answered with an exception or not at all</source>
        <translation>Запросов, на которые отвечено исключением или не отвечено</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Ошибок</translation>
    </message>
    <message>
        <source>Bytes received from the client</source>
        <translation>Байт принято от клиента</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Принято</translation>
    </message>
    <message>
        <source>Bytes sent to the client</source>
        <translation>Байт отправлено клиенту</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Отправлено</translation>
    </message>
</context>
<context>
    <name>gorizont::ClientsPage</name>
    <message>
        <source>&amp;Disconnect…</source>
        <translation>&amp;Отключить…</translation>
    </message>
    <message>
        <source>Nobody is connected.</source>
        <translation>Никто не подключён.</translation>
    </message>
    <message>
        <source>Disconnect the client %1 from %2?</source>
        <translation>Отключить клиента %1 от %2?</translation>
    </message>
    <message numerus="yes">
        <source>Disconnect %n client(s)?</source>
        <translation>
            <numerusform>Отключить %n клиента?</numerusform>
            <numerusform>Отключить %n клиентов?</numerusform>
            <numerusform>Отключить %n клиентов?</numerusform>
        </translation>
    </message>
    <message>
        <source>A client may connect again at once; ModbusAllow keeps it out for good.</source>
        <translation>Клиент может сразу подключиться снова; навсегда его не пустит ModbusAllow.</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Отключить</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>О&amp;тмена</translation>
    </message>
</context>
<context>
    <name>gorizont::ComplaintsDialog</name>
    <message>
        <source>Configuration file</source>
        <translation>Файл настроек</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the configuration file cannot be used as they are. The program works without them.</source>
        <translation>
            <numerusform>%n запись файла настроек нельзя использовать в том виде, как она есть. Программа работает без неё.</numerusform>
            <numerusform>%n записи файла настроек нельзя использовать в том виде, как они есть. Программа работает без них.</numerusform>
            <numerusform>%n записей файла настроек нельзя использовать в том виде, как они есть. Программа работает без них.</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Копировать</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
</context>
<context>
    <name>gorizont::ConfigFile</name>
    <message>
        <source>the file is far too large to be a configuration</source>
        <translation>файл слишком велик для файла настроек</translation>
    </message>
</context>
<context>
    <name>gorizont::CursorModel</name>
    <message>
        <source>Mean of all valid readings between the cursors</source>
        <translation>Среднее всех достоверных показаний между курсорами</translation>
    </message>
    <message>
        <source>Slope of the straight line of least squares, an hour</source>
        <translation>Наклон прямой наименьших квадратов за час</translation>
    </message>
    <message>
        <source>Slope of the straight line of least squares, a day</source>
        <translation>Наклон прямой наименьших квадратов за сутки</translation>
    </message>
    <message>
        <source>Share of the time between the cursors without gaps, %</source>
        <translation>Доля времени между курсорами без пропусков, %</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Кривая</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Среднее</translation>
    </message>
    <message>
        <source>Slope / h</source>
        <translation>Наклон / ч</translation>
    </message>
    <message>
        <source>Slope / day</source>
        <translation>Наклон / сут</translation>
    </message>
    <message>
        <source>Min.</source>
        <translation>Мин.</translation>
    </message>
    <message>
        <source>Max.</source>
        <translation>Макс.</translation>
    </message>
    <message>
        <source>Complete, %</source>
        <translation>Полнота, %</translation>
    </message>
</context>
<context>
    <name>gorizont::CursorPanel</name>
    <message>
        <source>Nothing is drawn.</source>
        <translation>Ничего не показано.</translation>
    </message>
    <message>
        <source>A: %1   B: %2   Between them: %3</source>
        <translation>A: %1   B: %2   Между ними: %3</translation>
    </message>
</context>
<context>
    <name>gorizont::CurveChooser</name>
    <message>
        <source>Find a sensor</source>
        <translation>Найти датчик</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>Что показано</translation>
    </message>
</context>
<context>
    <name>gorizont::DayCalendar</name>
    <message>
        <source>Days by completeness</source>
        <translation>Дни по полноте данных</translation>
    </message>
    <message>
        <source>nothing is known of this day</source>
        <translation>об этом дне данных нет</translation>
    </message>
    <message>
        <source>nothing is missing</source>
        <translation>пропусков нет</translation>
    </message>
    <message>
        <source>%1 % are there</source>
        <translation>есть %1 % данных</translation>
    </message>
    <message>
        <source>%1: %2 missing</source>
        <translation>%1: нет %2</translation>
    </message>
    <message numerus="yes">
        <source>and %n more sensor(s)</source>
        <translation>
            <numerusform>и ещё %n датчик</numerusform>
            <numerusform>и ещё %n датчика</numerusform>
            <numerusform>и ещё %n датчиков</numerusform>
        </translation>
    </message>
    <message>
        <source>en_GB</source>
        <extracomment>the locale of this language, as in ru_RU</extracomment>
        <translation>ru_RU</translation>
    </message>
</context>
<context>
    <name>gorizont::DeskSentences</name>
    <message>
        <source>%1: serving on port %2.</source>
        <translation>%1: сервер работает на порту %2.</translation>
    </message>
    <message>
        <source>%1: stopped.</source>
        <translation>%1: сервер остановлен.</translation>
    </message>
    <message>
        <source>%1: cannot serve on port %2 (%3). %4 Trying again every %5 s.</source>
        <translation>%1: порт %2 недоступен (%3). %4 Попытки повторяются каждые %5 с.</translation>
    </message>
    <message>
        <source>Another program uses this port. Stop that program or choose another %1.</source>
        <translation>Этот порт занят другой программой. Завершите её или выберите другой %1.</translation>
    </message>
    <message>
        <source>Ports below 1024 need a right. Choose another %1, or give the right once: sudo setcap cap_net_bind_service=+ep %2</source>
        <translation>Для портов ниже 1024 нужно право. Выберите другой %1 или дайте право один раз: sudo setcap cap_net_bind_service=+ep %2</translation>
    </message>
    <message>
        <source>This computer does not have the address given in ModbusBind.</source>
        <translation>У этого компьютера нет адреса, указанного в ModbusBind.</translation>
    </message>
    <message>
        <source>Check %1 and ModbusBind.</source>
        <translation>Проверьте %1 и ModbusBind.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; in ModbusBind is not an IP address. Not serving until it is corrected.</source>
        <translation>%1: «%2» в ModbusBind — не IP-адрес. Сервер не работает, пока он не исправлен.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; in ModbusAllow is neither an address nor a block of addresses. It is left out.</source>
        <translation>%1: «%2» в ModbusAllow — не адрес и не блок адресов. Значение пропущено.</translation>
    </message>
    <message>
        <source>%1: new clients cannot be accepted (%2). Those connected are served on. Trying again every second.</source>
        <translation>%1: новые клиенты не принимаются (%2). Подключённые обслуживаются. Попытки повторяются каждую секунду.</translation>
    </message>
    <message>
        <source>%1: new clients are accepted again.</source>
        <translation>%1: новые клиенты снова принимаются.</translation>
    </message>
    <message>
        <source>%1: client %2 connected.</source>
        <translation>%1: клиент %2 подключился.</translation>
    </message>
    <message>
        <source>%1: client %2 has not been here since %3.</source>
        <translation>%1: клиента %2 не было с %3.</translation>
    </message>
    <message>
        <source>%1: client %2 (its port %3) was cut off by the operator.</source>
        <translation>%1: клиент %2 (его порт %3) отключён оператором.</translation>
    </message>
    <message>
        <source>%1: client %2 was refused: ModbusAllow does not list it.</source>
        <translation>%1: клиенту %2 отказано: его нет в ModbusAllow.</translation>
    </message>
    <message>
        <source>%1: client %2 was disconnected: it does not speak %1 (wrong length of a request).</source>
        <translation>%1: клиент %2 отключён: его запросы не по протоколу %1 (неверная длина).</translation>
    </message>
    <message>
        <source>%1: client %2 sends what is no request (wrong length, address or command) and gets no answer.</source>
        <translation>%1: клиент %2 присылает не запросы (неверная длина, адрес или команда), ответа на них нет.</translation>
    </message>
    <message>
        <source>%1: client %2 was disconnected: it asks and does not read the answers.</source>
        <translation>%1: клиент %2 отключён: он запрашивает, но не читает ответы.</translation>
    </message>
    <message>
        <source>%1: client %2 was disconnected: it asked nothing for longer than ModbusIdle.</source>
        <translation>%1: клиент %2 отключён: не было запросов дольше ModbusIdle.</translation>
    </message>
    <message>
        <source>%1: client %2 was disconnected to make room: as many clients as ModbusClients allows, and it was silent the longest.</source>
        <translation>%1: клиент %2 отключён, чтобы освободить место: клиентов столько, сколько разрешает ModbusClients, а он молчал дольше всех.</translation>
    </message>
</context>
<context>
    <name>gorizont::DisplacementPage</name>
    <message>
        <source>Chain %1</source>
        <translation>Цепочка %1</translation>
    </message>
    <message>
        <source>Chain %1: %2</source>
        <translation>Цепочка %1: %2</translation>
    </message>
    <message>
        <source>&amp;Store as zero</source>
        <translation>&amp;Запомнить как нуль</translation>
    </message>
    <message>
        <source>&amp;Forget the zero…</source>
        <translation>З&amp;абыть нуль…</translation>
    </message>
    <message>
        <source>Chain of sensors</source>
        <translation>Цепочка датчиков</translation>
    </message>
    <message>
        <source>Keeps the present shape, to see what changes from now on</source>
        <translation>Запоминает нынешнее положение, чтобы видеть изменения с этого момента</translation>
    </message>
    <message>
        <source>The configuration names no chain of sensors ([Chain1]).</source>
        <translation>В конфигурации нет ни одной цепочки датчиков ([Chain1]).</translation>
    </message>
    <message>
        <source>Zero of %1</source>
        <translation>Нуль от %1</translation>
    </message>
    <message>
        <source>No zero is stored.</source>
        <translation>Нуль не сохранён.</translation>
    </message>
    <message>
        <source>The shape ends below the first sensor without a valid tilt.</source>
        <translation>Линия кончается ниже первого датчика, наклон которого недостоверен.</translation>
    </message>
    <message>
        <source>The zero was not stored: %1. Check the disk and the rights, then try again.</source>
        <translation>Нуль не сохранён: %1. Проверьте диск и права доступа и повторите.</translation>
    </message>
    <message>
        <source>Forget the zero of %1?</source>
        <translation>Забыть нуль от %1?</translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation>&amp;Забыть</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Отмена</translation>
    </message>
    <message>
        <source>The zero was not removed: %1. Check the rights, then try again.</source>
        <translation>Нуль не удалён: %1. Проверьте права доступа и повторите.</translation>
    </message>
    <message>
        <source>Sensors that are new or stand at another height are not compared.</source>
        <translation>Датчики, которые добавлены или стоят на другой высоте, не сравниваются.</translation>
    </message>
    <message>
        <source>Replace the zero of %1 by the present shape?</source>
        <translation>Заменить нуль от %1 нынешней формой?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Заменить</translation>
    </message>
</context>
<context>
    <name>gorizont::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Экспорт</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Экспорт</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>О&amp;тмена</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Name a file to write to.</source>
        <translation>Укажите файл для записи.</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>Файл %1 существует. Заменить?</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Заменить</translation>
    </message>
    <message>
        <source>Reading the archive…</source>
        <translation>Чтение архива…</translation>
    </message>
    <message>
        <source>Rows so far: %1</source>
        <translation>Строк: %1</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Отменено, ничего не записано.</translation>
    </message>
    <message>
        <source>Done, rows: %1. Written: %2</source>
        <translation>Готово, строк: %1. Записано: %2</translation>
    </message>
    <message>
        <source>Excel shows the first 1,048,575 rows only: export a shorter range, or minutes.</source>
        <translation>Excel покажет только первые 1 048 575 строк: выгрузите более короткий промежуток или минутные значения.</translation>
    </message>
</context>
<context>
    <name>gorizont::ExportForm</name>
    <message>
        <source>All sensors</source>
        <translation>Все датчики</translation>
    </message>
    <message>
        <source>All quantities</source>
        <translation>Все величины</translation>
    </message>
    <message>
        <source>Codes in miniSEED</source>
        <translation>Коды miniSEED</translation>
    </message>
    <message>
        <source>CSV for Excel (semicolons, local time)</source>
        <translation>CSV для Excel (точка с запятой, местное время)</translation>
    </message>
    <message>
        <source>CSV for programs (ISO 8601, UTC)</source>
        <translation>CSV для программ (ISO 8601, UTC)</translation>
    </message>
    <message>
        <source>miniSEED (samples of accelerometers)</source>
        <translation>miniSEED (отсчёты акселерометров)</translation>
    </message>
    <message>
        <source>each reading</source>
        <translation>каждое измерение</translation>
    </message>
    <message>
        <source>each minute: minimum, mean, maximum</source>
        <translation>каждая минута: минимум, среднее, максимум</translation>
    </message>
    <message>
        <source>each hour: minimum, mean, maximum</source>
        <translation>каждый час: минимум, среднее, максимум</translation>
    </message>
    <message>
        <source>each day: minimum, mean, maximum</source>
        <translation>каждые сутки: минимум, среднее, максимум</translation>
    </message>
    <message>
        <source>Network:</source>
        <translation>Сеть:</translation>
    </message>
    <message>
        <source>Station:</source>
        <translation>Станция:</translation>
    </message>
    <message>
        <source>Channel X:</source>
        <translation>Канал X:</translation>
    </message>
    <message>
        <source>Channel Y:</source>
        <translation>Канал Y:</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>Об&amp;зор…</translation>
    </message>
    <message>
        <source>&amp;From:</source>
        <translation>&amp;С:</translation>
    </message>
    <message>
        <source>&amp;To (not included):</source>
        <translation>&amp;До (не включая):</translation>
    </message>
    <message>
        <source>F&amp;ormat:</source>
        <translation>&amp;Формат:</translation>
    </message>
    <message>
        <source>&amp;Rows:</source>
        <translation>С&amp;троки:</translation>
    </message>
    <message>
        <source>Fi&amp;le:</source>
        <translation>Фай&amp;л:</translation>
    </message>
    <message>
        <source>File of the export</source>
        <translation>Файл экспорта</translation>
    </message>
</context>
<context>
    <name>gorizont::FirstRunDialog</name>
    <message>
        <source>Gorizont Server: first start</source>
        <translation>Gorizont Server: первый запуск</translation>
    </message>
    <message>
        <source>There is no configuration file GorizontServer.ini yet.</source>
        <translation>Файла настроек GorizontServer.ini пока нет.</translation>
    </message>
    <message>
        <source>It was looked for here:</source>
        <translation>Его искали здесь:</translation>
    </message>
    <message>
        <source>Start the demo</source>
        <translation>Запустить демонстрацию</translation>
    </message>
    <message>
        <source>A simulated site with sensors; no equipment is needed</source>
        <translation>Имитация объекта с датчиками, оборудование не нужно</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>Выбрать файл</translation>
    </message>
    <message>
        <source>Open a configuration file that already exists</source>
        <translation>Открыть уже существующий файл настроек</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Выход</translation>
    </message>
    <message>
        <source>Nothing is changed</source>
        <translation>Ничего не изменится</translation>
    </message>
    <message>
        <source>Configuration file</source>
        <translation>Файл настроек</translation>
    </message>
    <message>
        <source>Configuration files (*.ini);;All files (*)</source>
        <translation>Файлы настроек (*.ini);;Все файлы (*)</translation>
    </message>
</context>
<context>
    <name>gorizont::GapModel</name>
    <message>
        <source>goes on</source>
        <translation>продолжается</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Датчик</translation>
    </message>
    <message>
        <source>From</source>
        <translation>С</translation>
    </message>
    <message>
        <source>To</source>
        <translation>По</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Длительность</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Причина</translation>
    </message>
    <message>
        <source>Filled from</source>
        <translation>Восполнено из</translation>
    </message>
    <message>
        <source>the sensor was off</source>
        <translation>датчик был отключён</translation>
    </message>
    <message>
        <source>the port was off</source>
        <translation>порт был отключён</translation>
    </message>
    <message>
        <source>the port was not available</source>
        <translation>порт был недоступен</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>нет ответа</translation>
    </message>
    <message>
        <source>wrong check sums</source>
        <translation>ошибки контрольных сумм</translation>
    </message>
    <message>
        <source>the sensor reported a fault</source>
        <translation>датчик сообщил о неисправности</translation>
    </message>
    <message>
        <source>service mode</source>
        <translation>сервисный режим</translation>
    </message>
    <message>
        <source>the program was not running</source>
        <translation>программа не работала</translation>
    </message>
    <message>
        <source>the clock was set</source>
        <translation>переведены часы</translation>
    </message>
    <message>
        <source>the disk could not be written</source>
        <translation>диск был недоступен для записи</translation>
    </message>
</context>
<context>
    <name>gorizont::HistoryFiles</name>
    <message>
        <source>The history is being saved again.</source>
        <translation>Запись истории возобновлена.</translation>
    </message>
    <message>
        <source>The history is not being saved: %1. It is tried again every few seconds.</source>
        <translation>История не сохраняется: %1. Попытки повторяются каждые несколько секунд.</translation>
    </message>
    <message>
        <source>%1 did not end with a whole record; what was unfinished has been removed.</source>
        <translation>%1 заканчивался неполной записью; неполная часть удалена.</translation>
    </message>
</context>
<context>
    <name>gorizont::HistoryPage</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>Пропуски</translation>
    </message>
    <message>
        <source>Looking for gaps…</source>
        <translation>Поиск пропусков…</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>События</translation>
    </message>
    <message>
        <source>Looking for events…</source>
        <translation>Поиск событий…</translation>
    </message>
    <message>
        <source>The archive does not answer; F5 asks again.</source>
        <translation>Архив не отвечает; F5 — повторить запрос.</translation>
    </message>
    <message>
        <source>Gaps (%1)</source>
        <translation>Пропуски (%1)</translation>
    </message>
    <message>
        <source>Choose a sensor on the left.</source>
        <translation>Выберите датчик слева.</translation>
    </message>
    <message>
        <source>Nothing is missing in these days.</source>
        <translation>За эти дни пропусков нет.</translation>
    </message>
    <message>
        <source>Events (the last %1)</source>
        <translation>События (последние %1)</translation>
    </message>
    <message>
        <source>Events (%1)</source>
        <translation>События (%1)</translation>
    </message>
    <message>
        <source>No events in these days.</source>
        <translation>За эти дни событий нет.</translation>
    </message>
    <message>
        <source>All sensors</source>
        <translation>Все датчики</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Экспорт…</translation>
    </message>
    <message>
        <source>There is no archive. Switch it on in the section [Archive] of GorizontServer.ini and start the program again.</source>
        <translation>Архива нет. Включите его в секции [Archive] файла GorizontServer.ini и запустите программу снова.</translation>
    </message>
    <message>
        <source>Earlier months</source>
        <translation>Предыдущие месяцы</translation>
    </message>
    <message>
        <source>Later months</source>
        <translation>Следующие месяцы</translation>
    </message>
</context>
<context>
    <name>gorizont::HistoryWriter</name>
    <message>
        <source>The clock of the computer was set forward by %1 s.</source>
        <translation>Часы компьютера переведены вперёд на %1 с.</translation>
    </message>
    <message>
        <source>The clock of the computer was set back by %1 s.</source>
        <translation>Часы компьютера переведены назад на %1 с.</translation>
    </message>
    <message>
        <source>The disk was busy for too long: %1 samples and %2 events were not saved.</source>
        <translation>Диск был занят слишком долго: не сохранено отсчётов: %1, событий: %2.</translation>
    </message>
    <message>
        <source>The disk was busy for too long: %1 captures of L-VIMS were not saved.</source>
        <translation>Диск слишком долго был занят: не сохранено захватов L-VIMS: %1.</translation>
    </message>
</context>
<context>
    <name>gorizont::Ind3Dialog</name>
    <message>
        <source>C&amp;hange</source>
        <translation>&amp;Изменить</translation>
    </message>
    <message>
        <source>Apply the ne&amp;w settings</source>
        <translation>Применить &amp;новые настройки</translation>
    </message>
    <message>
        <source>Only sensors that speak this protocol are found. Another choice begins a new scan.</source>
        <translation>Обнаруживаются только датчики с этим протоколом. При выборе другого начинается новое сканирование.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Н&amp;е применять</translation>
    </message>
    <message>
        <source>Gives the sensor another address</source>
        <translation>Задать датчику другой адрес</translation>
    </message>
    <message>
        <source>The address can be changed only after a complete scan that was not stopped.</source>
        <translation>Изменить адрес можно только после полного сканирования, без остановки.</translation>
    </message>
    <message>
        <source>The new settings of sensor %1 were not applied. Discard them?</source>
        <translation>Новые настройки датчика %1 не применены. Продолжить без них?</translation>
    </message>
    <message>
        <source>Reading sensor %1…</source>
        <translation>Чтение параметров датчика %1…</translation>
    </message>
    <message>
        <source>Sensor %1 cannot be read: %2.</source>
        <translation>Параметры датчика %1 не прочитаны: %2.</translation>
    </message>
    <message>
        <source>The sensor reports that a check sum of its memory is wrong: it needs repair.</source>
        <translation>Датчик сообщает об ошибке контрольной суммы своей памяти: требуется ремонт.</translation>
    </message>
    <message>
        <source>Writing: %1…</source>
        <translation>Запись: %1…</translation>
    </message>
    <message>
        <source>%1, not written</source>
        <translation>%1, не записано</translation>
    </message>
    <message>
        <source>Sensor %1: %2.</source>
        <translation>Датчик %1: %2.</translation>
    </message>
    <message>
        <source>new address %1</source>
        <translation>новый адрес %1</translation>
    </message>
    <message>
        <source>%1, written</source>
        <translation>%1, записано</translation>
    </message>
    <message>
        <source>%1, not written: it is taken, or the sensor will not. Scan again.</source>
        <translation>%1, не записано: адрес занят, или датчик его не принимает. Повторите сканирование.</translation>
    </message>
    <message>
        <source>%1, not written: the sensor still answers at %2</source>
        <translation>%1, не записано: датчик отвечает по прежнему адресу %2</translation>
    </message>
    <message>
        <source>%1, %2: whether it was written is not known. Scan the line to find the sensor.</source>
        <translation>%1, %2: записано или нет, неизвестно. Найдите датчик сканированием.</translation>
    </message>
    <message>
        <source>Sensor %1: %2</source>
        <translation>Датчик %1: %2</translation>
    </message>
</context>
<context>
    <name>gorizont::Ind3Form</name>
    <message>
        <source>Exchange</source>
        <translation>Параметры обмена</translation>
    </message>
    <message>
        <source>Up to %1 characters: Latin, Cyrillic, digits and signs. The sensor keeps the name.</source>
        <translation>До %1 символов: латиница, кириллица, цифры и специальные символы. Имя хранится в датчике.</translation>
    </message>
    <message>
        <source>The speed is shown only; this program does not change it.</source>
        <translation>Скорость обмена только отображается, её изменение не допускается.</translation>
    </message>
    <message>
        <source>&amp;Address on the line:</source>
        <translation>&amp;Адрес на линии:</translation>
    </message>
    <message>
        <source>&amp;Name of the sensor:</source>
        <translation>И&amp;мя измерителя:</translation>
    </message>
    <message>
        <source>Speed:</source>
        <translation>Скорость обмена:</translation>
    </message>
    <message>
        <source>&amp;Protocol:</source>
        <translation>&amp;Протокол обмена:</translation>
    </message>
    <message>
        <source>About the device</source>
        <translation>Об устройстве</translation>
    </message>
    <message>
        <source>Version of the sensor:</source>
        <translation>Версия измерителя:</translation>
    </message>
    <message>
        <source>Software revision:</source>
        <translation>Номер редакции ПО:</translation>
    </message>
    <message>
        <source>Factory number:</source>
        <translation>Заводской номер:</translation>
    </message>
    <message>
        <source>Arc-seconds, from −%1 to +%1. Point and comma are both decimal marks.</source>
        <translation>Угловые секунды, от −%1 до +%1. Дробная часть отделяется точкой или запятой.</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Параметры измерения</translation>
    </message>
    <message>
        <source>Zero offset &amp;X, ″:</source>
        <translation>Смещение нуля &amp;X, ″:</translation>
    </message>
    <message>
        <source>Averaging &amp;ticks:</source>
        <translation>&amp;Тактов усреднения:</translation>
    </message>
    <message>
        <source>Zero offset &amp;Y, ″:</source>
        <translation>Смещение нуля &amp;Y, ″:</translation>
    </message>
    <message>
        <source>Averaging p&amp;eriod, ms:</source>
        <translation>П&amp;ериод усреднения, мс:</translation>
    </message>
    <message>
        <source>Tilt X, Y now, ″:</source>
        <translation>Наклон X, Y сейчас, ″:</translation>
    </message>
    <message>
        <source>Type %1, revision %2</source>
        <translation>Тип %1, редакция %2</translation>
    </message>
    <message>
        <source>The name needs 1…%1 characters: Latin, Cyrillic, digits and signs.</source>
        <translation>Имя: 1…%1 символов, латиница, кириллица, цифры, специальные символы.</translation>
    </message>
    <message>
        <source>An offset is a number from −%1 to +%1.</source>
        <translation>Смещение нуля: число от −%1 до +%1.</translation>
    </message>
</context>
<context>
    <name>gorizont::InfoPanel</name>
    <message>
        <source>Settings</source>
        <translation>Настройки</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Измерения</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Журнал</translation>
    </message>
</context>
<context>
    <name>gorizont::InputLamps</name>
    <message>
        <source>Digital inputs</source>
        <translation>Цифровые входы</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>неизвестно</translation>
    </message>
    <message>
        <source>Input %1: not known</source>
        <translation>Вход %1: неизвестно</translation>
    </message>
    <message>
        <source>Input %1: on</source>
        <translation>Вход %1: включён</translation>
    </message>
    <message>
        <source>Input %1: off</source>
        <translation>Вход %1: выключен</translation>
    </message>
</context>
<context>
    <name>gorizont::Inspection</name>
    <message>
        <source>There is no archive %1.</source>
        <translation>Архива %1 нет.</translation>
    </message>
    <message>
        <source>%1 is there already. Name another file.</source>
        <translation>%1 уже есть. Укажите другой файл.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>Не удаётся записать %1.</translation>
    </message>
</context>
<context>
    <name>gorizont::JournalPage</name>
    <message>
        <source>Errors</source>
        <translation>Ошибки</translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation>Включение</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Отключение</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Информация</translation>
    </message>
    <message>
        <source>Text of the event</source>
        <translation>Текст события</translation>
    </message>
    <message>
        <source>No event passes this filter.</source>
        <translation>Нет событий, подходящих под этот фильтр.</translation>
    </message>
    <message>
        <source>No events yet.</source>
        <translation>Событий пока нет.</translation>
    </message>
</context>
<context>
    <name>gorizont::LinePoller</name>
    <message>
        <source>%1 works normally again</source>
        <translation>%1 снова работает нормально</translation>
    </message>
    <message>
        <source>%1 does not answer; its port is silent for %2 s, so that it restarts</source>
        <translation>%1 не отвечает; порт молчит %2 с, чтобы устройство перезапустилось</translation>
    </message>
</context>
<context>
    <name>gorizont::LineWorker</name>
    <message>
        <source>%1: polling suspended for service</source>
        <translation>%1: опрос приостановлен для настройки</translation>
    </message>
    <message>
        <source>%1: service ended, polling goes on</source>
        <translation>%1: настройка завершена, опрос продолжен</translation>
    </message>
    <message>
        <source>%1 is open</source>
        <translation>%1 открыт</translation>
    </message>
    <message>
        <source>%1 cannot be opened (%2). Check the adapter and its port number; the program keeps trying.</source>
        <translation>%1 не открывается (%2). Проверьте адаптер и номер порта; программа повторяет попытки.</translation>
    </message>
    <message>
        <source>%1 is gone (%2). Check the adapter and its cable; the program opens the port again as soon as it can.</source>
        <translation>%1 пропал (%2). Проверьте адаптер и его кабель; программа откроет порт, как только это станет возможно.</translation>
    </message>
</context>
<context>
    <name>gorizont::Main</name>
    <message>
        <source>Gorizont Server already works with the folder %1. Close that copy, or give this one a folder of its own with --data.</source>
        <translation>Gorizont Server уже работает с папкой %1. Закройте ту копию или задайте этой отдельную папку ключом --data.</translation>
    </message>
    <message>
        <source>There is no GorizontServer.ini. Name one with --config, or look at the program with --demo.</source>
        <translation>Нет файла GorizontServer.ini. Укажите его ключом --config или посмотрите программу с ключом --demo.</translation>
    </message>
    <message>
        <source>There is no display. Start the program with --headless.</source>
        <translation>Нет экрана. Запустите программу с ключом --headless.</translation>
    </message>
    <message>
        <source>With CanOPCDA=1 only one copy of the program may work, and another one serves OPC DA already. Close that copy, or set CanOPCDA=0 for this one.</source>
        <translation>При CanOPCDA=1 может работать только одна копия программы, и другая копия уже обслуживает OPC DA. Закройте её или задайте для этой CanOPCDA=0.</translation>
    </message>
</context>
<context>
    <name>gorizont::MainWindow</name>
    <message>
        <source>End the work of the program?</source>
        <translation>Завершить работу программы?</translation>
    </message>
    <message>
        <source>Polling of the sensors, records and the data server will stop.</source>
        <translation>Опрос датчиков, запись и передача данных прекратятся.</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Да</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Нет</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>E&amp;xit</source>
        <translation>В&amp;ыход</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Вид</translation>
    </message>
    <message>
        <source>&amp;Ports</source>
        <translation>&amp;Порты</translation>
    </message>
    <message>
        <source>&amp;Sensors</source>
        <translation>&amp;Датчики</translation>
    </message>
    <message>
        <source>P&amp;ort</source>
        <translation>П&amp;орт</translation>
    </message>
    <message>
        <source>S&amp;ensor</source>
        <translation>Д&amp;атчик</translation>
    </message>
    <message>
        <source>Se&amp;ttings</source>
        <translation>&amp;Настройки</translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation>&amp;Измерения</translation>
    </message>
    <message>
        <source>&amp;Journal</source>
        <translation>&amp;Журнал</translation>
    </message>
    <message>
        <source>&amp;Find a sensor</source>
        <translation>Найти да&amp;тчик</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Справка</translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation>&amp;О программе</translation>
    </message>
    <message>
        <source>Messages for the &amp;dispatcher</source>
        <translation>Сооб&amp;щения для диспетчера</translation>
    </message>
    <message>
        <source>&amp;Refresh</source>
        <translation>О&amp;бновить</translation>
    </message>
    <message>
        <source>Restore &amp;columns</source>
        <translation>&amp;Восстановить столбцы</translation>
    </message>
    <message>
        <source>&amp;Service</source>
        <translation>С&amp;ервис</translation>
    </message>
    <message>
        <source>Modbus &amp;register map…</source>
        <translation>Карта &amp;регистров Modbus…</translation>
    </message>
    <message>
        <source>C&amp;lients</source>
        <translation>&amp;Клиенты</translation>
    </message>
    <message>
        <source>&amp;OPC DA tags…</source>
        <translation>&amp;Тэги OPC DA…</translation>
    </message>
</context>
<context>
    <name>gorizont::MeasurementModel</name>
    <message>
        <source>Time</source>
        <translation>Время</translation>
    </message>
    <message>
        <source>Ports</source>
        <translation>Порты</translation>
    </message>
    <message>
        <source>%1: X, ″</source>
        <translation>%1: X, ″</translation>
    </message>
    <message>
        <source>%1: Y, ″</source>
        <translation>%1: Y, ″</translation>
    </message>
    <message>
        <source>%1: T, °C</source>
        <translation>%1: T, °C</translation>
    </message>
    <message>
        <source>%1: P, %</source>
        <translation>%1: P, %</translation>
    </message>
    <message>
        <source>%1: status</source>
        <translation>%1: статус</translation>
    </message>
    <message>
        <source>Time and date of the record</source>
        <translation>Время и дата записи</translation>
    </message>
    <message>
        <source>Status word of the channel, the first port at the right: 0 no errors, 1 cannot be opened, 2 write errors, 3 off or not there</source>
        <translation>Слово состояния канала, первый порт справа: 0 — нет ошибок, 1 — не открывается, 2 — ошибки записи, 3 — опрос отключен или порта нет</translation>
    </message>
    <message>
        <source>%1: angle along X, arc-seconds</source>
        <translation>%1: угол наклона по X, угл. сек.</translation>
    </message>
    <message>
        <source>%1: angle along Y, arc-seconds</source>
        <translation>%1: угол наклона по Y, угл. сек.</translation>
    </message>
    <message>
        <source>%1: temperature, °C; empty if the sensor has none</source>
        <translation>%1: температура, °C; пусто, если датчик её не измеряет</translation>
    </message>
    <message>
        <source>%1: power of the thermostat&apos;s heater, %</source>
        <translation>%1: мощность нагревательного элемента термостата, %</translation>
    </message>
    <message>
        <source>%1: status word, the code and bits 11…0</source>
        <translation>%1: слово состояния датчика, код и биты 11…0</translation>
    </message>
</context>
<context>
    <name>gorizont::MeasurementsPage</name>
    <message>
        <source>No measurement yet: a line comes every %1 s.</source>
        <translation>Измерений пока нет: строка добавляется каждые %1 с.</translation>
    </message>
</context>
<context>
    <name>gorizont::Measuring</name>
    <message>
        <source>Self-check of the gamma sensor: good (%1 pulses, %2 with the blinker).</source>
        <translation>Самопроверка гамма-датчика: исправен (импульсов: %1, с бленкером: %2).</translation>
    </message>
    <message>
        <source>Self-check of the gamma sensor: it does not react to the blinker (%1 pulses, %2 with the blinker).</source>
        <translation>Самопроверка гамма-датчика: он не реагирует на бленкер (импульсов: %1, с бленкером: %2).</translation>
    </message>
    <message>
        <source>The outputs are set again.</source>
        <translation>Выходы снова устанавливаются.</translation>
    </message>
    <message>
        <source>An output cannot be set (%1); it is tried again and again.</source>
        <translation>Не удаётся установить выход (%1); попытки повторяются.</translation>
    </message>
</context>
<context>
    <name>gorizont::MessageQueue</name>
    <message>
        <source>MQTT: the queue did not end with a whole reading; what was unfinished has been removed.</source>
        <translation>MQTT: очередь заканчивалась неполным измерением; незаконченное удалено.</translation>
    </message>
    <message>
        <source>MQTT: the queue is not being saved: %1. Readings wait in memory, and it is tried again every few seconds.</source>
        <translation>MQTT: очередь не сохраняется: %1. Измерения ждут в памяти, попытки повторяются каждые несколько секунд.</translation>
    </message>
    <message>
        <source>MQTT: the queue is being saved again.</source>
        <translation>MQTT: очередь снова сохраняется.</translation>
    </message>
    <message>
        <source>MQTT: the queue is full. The oldest readings are lost until the broker takes them again; QueueLimit in [MQTT] makes it longer.</source>
        <translation>MQTT: очередь заполнена. Самые старые измерения теряются, пока брокер не начнёт их принимать; увеличить очередь можно ключом QueueLimit в [MQTT].</translation>
    </message>
    <message>
        <source>MQTT: the queue on the disk is damaged, readings in it are lost: %1.</source>
        <translation>MQTT: очередь на диске повреждена, потеряно измерений: %1.</translation>
    </message>
    <message>
        <source>MQTT: lost because the queue was full, readings: %1.</source>
        <translation>MQTT: из-за переполнения очереди потеряно измерений: %1.</translation>
    </message>
</context>
<context>
    <name>gorizont::Mk14Dialog</name>
    <message>
        <source>The new control word of station %1 was not sent. Discard it?</source>
        <translation>Новое управляющее слово станции %1 не отправлено. Отказаться от него?</translation>
    </message>
    <message>
        <source>Reading station %1…</source>
        <translation>Чтение станции %1…</translation>
    </message>
    <message>
        <source>Station %1 cannot be read: %2.</source>
        <translation>Станцию %1 прочитать не удалось: %2.</translation>
    </message>
    <message>
        <source>Station %1 answers, but it has no data yet.</source>
        <translation>Станция %1 отвечает, но у неё ещё нет данных.</translation>
    </message>
    <message>
        <source>Station %1 was read.</source>
        <translation>Станция %1 прочитана.</translation>
    </message>
    <message>
        <source>To keep it, write Outputs%1=%2 into [Port%3] of the configuration file.</source>
        <translation>Чтобы сохранить его, впишите Outputs%1=%2 в раздел [Port%3] файла настроек.</translation>
    </message>
    <message>
        <source>Writing: %1…</source>
        <translation>Запись: %1…</translation>
    </message>
    <message>
        <source>Station %1: %2</source>
        <translation>Станция %1: %2</translation>
    </message>
    <message>
        <source>Set the outputs of station %1 to %2? Whatever is connected to them is switched at once.</source>
        <translation>Установить выходы станции %1 в %2? Всё, что к ним подключено, переключится сразу.</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>&amp;Установить</translation>
    </message>
    <message>
        <source>outputs %1</source>
        <translation>выходы %1</translation>
    </message>
    <message>
        <source>%1, confirmed. %2</source>
        <translation>%1, подтверждено. %2</translation>
    </message>
    <message>
        <source>%1, not confirmed (%2): whether the outputs were switched is not known; polling goes on with the word before.</source>
        <translation>%1, не подтверждено (%2): переключились ли выходы, неизвестно; опрос продолжается с прежним словом.</translation>
    </message>
    <message>
        <source>Set the clock of station %1 to the time of this computer, UTC? Times of its records will step.</source>
        <translation>Установить часы станции %1 по этому компьютеру, UTC? Время в её записях изменится скачком.</translation>
    </message>
    <message>
        <source>Set the clock of station %1 to the local time of this computer? Times of its records will step.</source>
        <translation>Установить часы станции %1 по местному времени этого компьютера? Время в её записях изменится скачком.</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>часы</translation>
    </message>
    <message>
        <source>%1, not confirmed (%2): whether it was set is not known.</source>
        <translation>%1, не подтверждено (%2): установлены ли они, неизвестно.</translation>
    </message>
    <message>
        <source>%1 set to %2, confirmed</source>
        <translation>%1 установлены на %2, подтверждено</translation>
    </message>
    <message>
        <source>Settings file for the station</source>
        <translation>Файл настройки для станции</translation>
    </message>
    <message numerus="yes">
        <source>Send %1 (%n byte(s)) to station %2? It replaces the station&apos;s own file of this name. A wrong file may stop its measurements.</source>
        <translation>
            <numerusform>Отправить %1 (%n байт) на станцию %2? Он заменит её собственный файл с этим именем. Неверный файл может остановить измерения.</numerusform>
            <numerusform>Отправить %1 (%n байта) на станцию %2? Он заменит её собственный файл с этим именем. Неверный файл может остановить измерения.</numerusform>
            <numerusform>Отправить %1 (%n байт) на станцию %2? Он заменит её собственный файл с этим именем. Неверный файл может остановить измерения.</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>&amp;Отправить</translation>
    </message>
    <message numerus="yes">
        <source>file %1, %n byte(s)</source>
        <translation>
            <numerusform>файл %1, %n байт</numerusform>
            <numerusform>файл %1, %n байта</numerusform>
            <numerusform>файл %1, %n байт</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, confirmed</source>
        <translation>%1, подтверждено</translation>
    </message>
    <message>
        <source>%1, not confirmed (%2): the station may have it or not. Send it again.</source>
        <translation>%1, не подтверждено (%2): получила ли его станция, неизвестно. Отправьте его ещё раз.</translation>
    </message>
</context>
<context>
    <name>gorizont::Mk14Form</name>
    <message>
        <source>Values</source>
        <translation>Значения</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Выходы</translation>
    </message>
    <message>
        <source>Clock and files</source>
        <translation>Часы и файлы</translation>
    </message>
    <message>
        <source>Exchange</source>
        <translation>Параметры обмена</translation>
    </message>
    <message>
        <source>Add&amp;ress of the station:</source>
        <translation>Ад&amp;рес станции:</translation>
    </message>
</context>
<context>
    <name>gorizont::Mk14OutputsPanel</name>
    <message>
        <source>Set the &amp;outputs…</source>
        <translation>Установить в&amp;ыходы…</translation>
    </message>
    <message>
        <source>The same as a number: decimal, or hexadecimal with 0x in front</source>
        <translation>То же числом: десятичным или шестнадцатеричным с 0x впереди</translation>
    </message>
    <message>
        <source>Every poll repeats the control word that was set last, so that polling switches nothing. What is set here holds until the program ends; after its next start Outputs{i} of the configuration file holds.</source>
        <translation>Каждый опрос повторяет последнее установленное управляющее слово, поэтому сам опрос ничего не переключает. Установленное здесь действует до завершения программы; после следующего запуска действует Outputs{i} из файла настроек.</translation>
    </message>
    <message>
        <source>Control &amp;word:</source>
        <translation>Управляющее &amp;слово:</translation>
    </message>
    <message>
        <source>In force:</source>
        <translation>Действует:</translation>
    </message>
    <message>
        <source>Output %1</source>
        <translation>Выход %1</translation>
    </message>
</context>
<context>
    <name>gorizont::Mk14TransferPanel</name>
    <message>
        <source>Clock of the station</source>
        <translation>Часы станции</translation>
    </message>
    <message>
        <source>Set the c&amp;lock…</source>
        <translation>Установить &amp;часы…</translation>
    </message>
    <message>
        <source>Time that is sent:</source>
        <translation>Отправляется время:</translation>
    </message>
    <message>
        <source>Settings file</source>
        <translation>Файл настройки</translation>
    </message>
    <message>
        <source>The station replaces its own file of this name and may work by it at once or after a restart. Keep a copy of the old one: it cannot be read back.</source>
        <translation>Станция заменит свой файл с этим именем и начнёт работать по нему сразу или после перезапуска. Сохраните копию прежнего: прочитать его со станции нельзя.</translation>
    </message>
    <message>
        <source>C&amp;hoose the file…</source>
        <translation>Выбрать &amp;файл…</translation>
    </message>
    <message>
        <source>The name under which the station gets the file, in Latin letters</source>
        <translation>Имя, под которым станция получит файл, латинскими буквами</translation>
    </message>
    <message>
        <source>&amp;Send the file…</source>
        <translation>&amp;Отправить файл…</translation>
    </message>
    <message>
        <source>&amp;Name in the station:</source>
        <translation>&amp;Имя на станции:</translation>
    </message>
    <message>
        <source>The configuration file says that the clock of this station shows UTC (StationClock=UTC).</source>
        <translation>По файлу настроек часы этой станции показывают UTC (StationClock=UTC).</translation>
    </message>
    <message>
        <source>The clock of this station shows local time; StationClock{i}=UTC in the configuration file would say otherwise.</source>
        <translation>Часы этой станции показывают местное время; иначе в файле настроек стояло бы StationClock{i}=UTC.</translation>
    </message>
    <message>
        <source>The file cannot be read: %1. Choose another one.</source>
        <translation>Файл прочитать не удалось: %1. Выберите другой.</translation>
    </message>
    <message>
        <source>The file is empty: the station would lose its settings. Choose another one.</source>
        <translation>Файл пуст: станция потеряла бы свои настройки. Выберите другой.</translation>
    </message>
    <message>
        <source>The file has more than %1 bytes: the station takes only small ones. Choose another one.</source>
        <translation>В файле больше %1 байт: станция принимает только небольшие. Выберите другой.</translation>
    </message>
    <message>
        <source>No file is chosen.</source>
        <translation>Файл не выбран.</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n byte(s)</source>
        <translation>
            <numerusform>%1, %n байт</numerusform>
            <numerusform>%1, %n байта</numerusform>
            <numerusform>%1, %n байт</numerusform>
        </translation>
    </message>
    <message>
        <source>The name may have Latin letters, digits and signs, but no blanks and no folders.</source>
        <translation>В имени могут быть латинские буквы, цифры и знаки, но не пробелы и не папки.</translation>
    </message>
</context>
<context>
    <name>gorizont::Mk14ValuesPanel</name>
    <message>
        <source>&amp;Read now</source>
        <translation>П&amp;рочитать</translation>
    </message>
    <message>
        <source>mean values</source>
        <translation>средние значения</translation>
    </message>
    <message>
        <source>mean, instantaneous</source>
        <translation>средние, мгновенные</translation>
    </message>
    <message>
        <source>mean, minimum, maximum</source>
        <translation>средние, минимум, максимум</translation>
    </message>
    <message>
        <source>mean, instantaneous, minimum, maximum</source>
        <translation>средние, мгновенные, минимум, максимум</translation>
    </message>
    <message>
        <source>the same and mean voltages</source>
        <translation>то же и средние напряжения</translation>
    </message>
    <message>
        <source>the same and instantaneous voltages</source>
        <translation>то же и мгновенные напряжения</translation>
    </message>
    <message>
        <source>mean, maximum since the last request, σ</source>
        <translation>средние, максимум за срок, σ</translation>
    </message>
    <message>
        <source>mean, σ and maximum of the wind, precipitation</source>
        <translation>средние, σ и максимум ветра, осадки</translation>
    </message>
    <message>
        <source>Commands 7 and 8 make the station begin a new maximum.</source>
        <translation>По командам 7 и 8 станция начинает новый максимум за срок.</translation>
    </message>
    <message>
        <source>Values of the station</source>
        <translation>Значения станции</translation>
    </message>
    <message>
        <source>Precipitation</source>
        <translation>Осадки</translation>
    </message>
    <message>
        <source>No precipitation. Only command 8 brings it.</source>
        <translation>Осадков нет. Их передаёт только команда 8.</translation>
    </message>
    <message>
        <source>Data &amp;command:</source>
        <translation>&amp;Команда данных:</translation>
    </message>
    <message>
        <source>Digital inputs:</source>
        <translation>Цифровые входы:</translation>
    </message>
    <message>
        <source>The station has no data yet.</source>
        <translation>У станции ещё нет данных.</translation>
    </message>
    <message>
        <source>Nothing has been read.</source>
        <translation>Ничего не прочитано.</translation>
    </message>
</context>
<context>
    <name>gorizont::ModemPort</name>
    <message>
        <source>pulses of the wind can be counted on Linux only</source>
        <translation>импульсы ветра можно считать только в Linux</translation>
    </message>
</context>
<context>
    <name>gorizont::NewAddressDialog</name>
    <message>
        <source>New address</source>
        <translation>Новый адрес</translation>
    </message>
    <message>
        <source>Addresses where a sensor was found are not offered.</source>
        <translation>Адреса обнаруженных датчиков не предлагаются.</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Применить</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>О&amp;тмена</translation>
    </message>
    <message>
        <source>Address on the line:</source>
        <translation>Адрес на линии:</translation>
    </message>
    <message>
        <source>&amp;New address:</source>
        <translation>&amp;Новый адрес:</translation>
    </message>
</context>
<context>
    <name>gorizont::OpcSetup</name>
    <message>
        <source>OPC DA: the list of tags is new (tags: %1). It was written to %2.</source>
        <translation>OPC DA: новый список тэгов (тэгов: %1). Он записан в %2.</translation>
    </message>
    <message>
        <source>OPC DA: the gateway could not be registered. %1</source>
        <translation>OPC DA: шлюз не удалось зарегистрировать. %1</translation>
    </message>
    <message>
        <source>OPC DA: the server OPC.DA.GorizontServer was registered. Later runs need no administrator.</source>
        <translation>OPC DA: сервер OPC.DA.GorizontServer зарегистрирован. Дальше права администратора не нужны.</translation>
    </message>
    <message>
        <source>OPC DA: %1 cannot be written (%2). Check the rights of the folder and the room on the disk.</source>
        <translation>OPC DA: файл %1 не удалось записать (%2). Проверьте права на папку и место на диске.</translation>
    </message>
</context>
<context>
    <name>gorizont::OpcTagsDialog</name>
    <message>
        <source>OPC DA tags</source>
        <translation>Тэги OPC DA</translation>
    </message>
    <message>
        <source>Find a tag</source>
        <translation>Найти тэг</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Тэг</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Описание</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Копировать всё</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Сохранить как…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Save the tags</source>
        <translation>Сохранить тэги</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Текст (*.txt)</translation>
    </message>
    <message>
        <source>The file cannot be saved.</source>
        <translation>Файл не удалось сохранить.</translation>
    </message>
</context>
<context>
    <name>gorizont::Options</name>
    <message>
        <source>The configuration, GorizontServer.ini.</source>
        <translation>Файл настроек GorizontServer.ini.</translation>
    </message>
    <message>
        <source>Where History goes; default: the folder of the ini.</source>
        <translation>Папка для History; по умолчанию — папка файла настроек.</translation>
    </message>
    <message>
        <source>Port number n is opened as DIR/COMn.</source>
        <translation>Порт с номером n открывается как DIR/COMn.</translation>
    </message>
    <message>
        <source>No window; ends on SIGINT or SIGTERM.</source>
        <translation>Без окна; завершается по SIGINT или SIGTERM.</translation>
    </message>
    <message>
        <source>A simulated building, no files to prepare.</source>
        <translation>Имитация здания, файлы готовить не нужно.</translation>
    </message>
    <message>
        <source>Language of the program.</source>
        <translation>Язык программы.</translation>
    </message>
    <message>
        <source>Prints each new reading as one line of JSON.</source>
        <translation>Печатать каждое новое показание строкой JSON.</translation>
    </message>
    <message>
        <source>Prints this.</source>
        <translation>Показать эту справку.</translation>
    </message>
    <message>
        <source>Prints the version.</source>
        <translation>Показать версию.</translation>
    </message>
    <message>
        <source>Polls inclinometers and accelerometers, shows, saves and serves their readings.</source>
        <translation>Опрашивает инклинометры и акселерометры, показывает, сохраняет и передаёт их показания.</translation>
    </message>
    <message>
        <source>Unexpected argument: %1</source>
        <translation>Лишний аргумент: %1</translation>
    </message>
    <message>
        <source>--lang takes ru or en, not %1</source>
        <translation>--lang принимает ru или en, а не %1</translation>
    </message>
    <message>
        <source>--demo brings its own configuration; leave --config away</source>
        <translation>--demo использует свои настройки; уберите --config</translation>
    </message>
    <message>
        <source>Prints the Modbus registers of the configuration as Markdown.</source>
        <translation>Печатает регистры Modbus этой конфигурации в формате Markdown.</translation>
    </message>
    <message>
        <source>Prints the tags of OPC DA: name, type and description, parted by tabs.</source>
        <translation>Печатает тэги OPC DA: имя, тип и описание через табуляцию.</translation>
    </message>
</context>
<context>
    <name>gorizont::PortGroup</name>
    <message>
        <source>COM port</source>
        <translation>COM-порт</translation>
    </message>
    <message>
        <source>Number:</source>
        <translation>Номер:</translation>
    </message>
    <message>
        <source>Speed:</source>
        <translation>Скорость обмена:</translation>
    </message>
    <message>
        <source>The configuration file decides about the port.</source>
        <translation>Параметры порта определяет файл конфигурации.</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Закрыть</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Открыть</translation>
    </message>
    <message>
        <source>Ends service: the sensors of the port are polled again. The window stays.</source>
        <translation>Завершает сервисный режим: опрос датчиков порта продолжается. Окно остаётся открытым.</translation>
    </message>
    <message>
        <source>Takes the port into service again and scans it.</source>
        <translation>Снова переводит порт в сервисный режим и сканирует линию.</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Порт</translation>
    </message>
    <message>
        <source>Network address:</source>
        <translation>Сетевой адрес:</translation>
    </message>
</context>
<context>
    <name>gorizont::PortModel</name>
    <message>
        <source>How long the port has been open, h:mm:ss</source>
        <translation>Время непрерывной работы порта, ч:мм:сс</translation>
    </message>
    <message>
        <source>Bytes sent</source>
        <translation>Количество отправленных байт</translation>
    </message>
    <message>
        <source>Bytes received</source>
        <translation>Количество принятых байт</translation>
    </message>
    <message>
        <source>Failed attempts to open the port</source>
        <translation>Количество неудачных попыток открытия порта</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Порт</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Время</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Отправлено</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Принято</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Попыток</translation>
    </message>
    <message>
        <source>Logical name of the port</source>
        <translation>Логическое название порта</translation>
    </message>
    <message>
        <source>Present state of the port</source>
        <translation>Текущее состояние порта</translation>
    </message>
</context>
<context>
    <name>gorizont::PortsPage</name>
    <message>
        <source>The configuration file lists no ports.</source>
        <translation>В файле настроек нет портов.</translation>
    </message>
</context>
<context>
    <name>gorizont::PrecipitationModel</name>
    <message>
        <source>goes on</source>
        <translation>идут</translation>
    </message>
    <message>
        <source>When it began to rain, local time, by the clock of the station</source>
        <translation>Когда начались осадки, местное время по часам станции</translation>
    </message>
    <message>
        <source>Rain began</source>
        <translation>Начало осадков</translation>
    </message>
    <message>
        <source>When the rain ended, local time, by the clock of the station</source>
        <translation>Когда осадки закончились, местное время по часам станции</translation>
    </message>
    <message>
        <source>Rain ended</source>
        <translation>Конец осадков</translation>
    </message>
    <message>
        <source>How long it rained, h:mm:ss</source>
        <translation>Сколько шли осадки, ч:мм:сс</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Длительность</translation>
    </message>
</context>
<context>
    <name>gorizont::ProfileModel</name>
    <message>
        <source>Number of the sensor</source>
        <translation>Номер датчика</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>№</translation>
    </message>
    <message>
        <source>Where the sensor is installed</source>
        <translation>Где установлен датчик</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Место</translation>
    </message>
    <message>
        <source>Upper end of the link over the foot of the chain, m</source>
        <translation>Высота верхнего конца звена над основанием цепочки, м</translation>
    </message>
    <message>
        <source>H, m</source>
        <translation>H, м</translation>
    </message>
    <message>
        <source>Tilt along X, degrees</source>
        <translation>Наклон по X, градусы</translation>
    </message>
    <message>
        <source>Mx, °</source>
        <translation>Mx, °</translation>
    </message>
    <message>
        <source>Tilt along Y, degrees</source>
        <translation>Наклон по Y, градусы</translation>
    </message>
    <message>
        <source>My, °</source>
        <translation>My, °</translation>
    </message>
    <message>
        <source>Displacement along X over the link, L·sin α, mm</source>
        <translation>Перемещение по X на звене, L·sin α, мм</translation>
    </message>
    <message>
        <source>Link X, mm</source>
        <translation>Звено X, мм</translation>
    </message>
    <message>
        <source>Displacement along Y over the link, L·sin α, mm</source>
        <translation>Перемещение по Y на звене, L·sin α, мм</translation>
    </message>
    <message>
        <source>Link Y, mm</source>
        <translation>Звено Y, мм</translation>
    </message>
    <message>
        <source>Displacement along X over the foot of the chain, mm</source>
        <translation>Перемещение по X относительно основания цепочки, мм</translation>
    </message>
    <message>
        <source>X, mm</source>
        <translation>X, мм</translation>
    </message>
    <message>
        <source>Displacement along Y over the foot of the chain, mm</source>
        <translation>Перемещение по Y относительно основания цепочки, мм</translation>
    </message>
    <message>
        <source>Y, mm</source>
        <translation>Y, мм</translation>
    </message>
    <message>
        <source>Displacement along X since the zero was stored, mm</source>
        <translation>Перемещение по X с момента, когда запомнен нуль, мм</translation>
    </message>
    <message>
        <source>ΔX, mm</source>
        <translation>ΔX, мм</translation>
    </message>
    <message>
        <source>Displacement along Y since the zero was stored, mm</source>
        <translation>Перемещение по Y с момента, когда запомнен нуль, мм</translation>
    </message>
    <message>
        <source>ΔY, mm</source>
        <translation>ΔY, мм</translation>
    </message>
</context>
<context>
    <name>gorizont::ProfilePlot</name>
    <message>
        <source>Displacement along X, mm</source>
        <translation>Перемещение по X, мм</translation>
    </message>
    <message>
        <source>Displacement along Y, mm</source>
        <translation>Перемещение по Y, мм</translation>
    </message>
    <message>
        <source>Height, m</source>
        <translation>Высота, м</translation>
    </message>
    <message>
        <source>now</source>
        <translation>сейчас</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>нуль</translation>
    </message>
</context>
<context>
    <name>gorizont::PropertyModel</name>
    <message>
        <source>Parameter</source>
        <translation>Параметр</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Пояснение</translation>
    </message>
    <message>
        <source>in the configuration file: %1</source>
        <translation>в файле настроек: %1</translation>
    </message>
</context>
<context>
    <name>gorizont::PulseSource</name>
    <message>
        <source>the port gives no signals any more</source>
        <translation>порт больше не даёт сигналов</translation>
    </message>
</context>
<context>
    <name>gorizont::RangeActions</name>
    <message>
        <source>10 min</source>
        <translation>10 мин</translation>
    </message>
    <message>
        <source>1 h</source>
        <translation>1 ч</translation>
    </message>
    <message>
        <source>1 day</source>
        <translation>1 сут</translation>
    </message>
    <message>
        <source>1 week</source>
        <translation>1 нед</translation>
    </message>
    <message>
        <source>1 month</source>
        <translation>1 мес</translation>
    </message>
    <message>
        <source>1 year</source>
        <translation>1 год</translation>
    </message>
</context>
<context>
    <name>gorizont::ReceivedFile</name>
    <message>
        <source>A station takes no file of this name from a line.</source>
        <translation>Файл с таким именем станция с линии не принимает.</translation>
    </message>
</context>
<context>
    <name>gorizont::RecordedSource</name>
    <message>
        <source>line %1: %2</source>
        <translation>строка %1: %2</translation>
    </message>
    <message>
        <source>the first column must be called time</source>
        <translation>первый столбец должен называться time</translation>
    </message>
    <message>
        <source>%1 is no channel</source>
        <translation>%1 — не канал</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are expected</source>
        <translation>
            <numerusform>ожидается %n значение</numerusform>
            <numerusform>ожидаются %n значения</numerusform>
            <numerusform>ожидается %n значений</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is no number</source>
        <translation>%1 — не число</translation>
    </message>
    <message>
        <source>it holds no values</source>
        <translation>в нём нет значений</translation>
    </message>
    <message>
        <source>the time does not go on</source>
        <translation>время не возрастает</translation>
    </message>
    <message>
        <source>it is longer than 64 MB</source>
        <translation>он больше 64 МБ</translation>
    </message>
</context>
<context>
    <name>gorizont::RegisterMapDialog</name>
    <message>
        <source>Modbus register map</source>
        <translation>Карта регистров Modbus</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Копировать всё</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Сохранить как…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>Save the register map</source>
        <translation>Сохранение карты регистров</translation>
    </message>
    <message>
        <source>Markdown (*.md)</source>
        <translation>Markdown (*.md)</translation>
    </message>
    <message>
        <source>The file cannot be saved.</source>
        <translation>Не удалось сохранить файл.</translation>
    </message>
</context>
<context>
    <name>gorizont::ScanPanel</name>
    <message>
        <source>Sensors found on the line:</source>
        <translation>Всего обнаружено датчиков на линии:</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>О&amp;становить</translation>
    </message>
    <message>
        <source>&amp;Scan</source>
        <translation>&amp;Сканировать</translation>
    </message>
    <message>
        <source>Address %1 of %2 is asked.</source>
        <translation>Опрашивается адрес %1 из %2.</translation>
    </message>
    <message>
        <source>Found: %1.</source>
        <translation>Обнаружены: %1.</translation>
    </message>
    <message>
        <source>Unclear: %1. Somebody answers there, but the answers are damaged: two sensors with one address look like that. Disconnect one of them and scan again.</source>
        <translation>Неясно: %1. Оттуда приходят повреждённые ответы: так выглядят два датчика с одним адресом. Отключите один из них и повторите сканирование.</translation>
    </message>
    <message>
        <source>Nobody answers. Check power, cable and speed.</source>
        <translation>Никто не отвечает. Проверьте питание, кабель и скорость обмена.</translation>
    </message>
    <message>
        <source>The scan is not complete: a sensor cannot get a new address before all %1 addresses were asked.</source>
        <translation>Сканирование неполное: изменить адрес датчика можно, когда опрошены все %1 адресов.</translation>
    </message>
</context>
<context>
    <name>gorizont::SensorModel</name>
    <message>
        <source>Angle along X, degrees</source>
        <translation>Угол по X, угл. град.</translation>
    </message>
    <message>
        <source>Angle along Y, degrees</source>
        <translation>Угол по Y, угл. град.</translation>
    </message>
    <message>
        <source>Maximum acceleration, mm/s²</source>
        <translation>Максимальное ускорение, мм/с²</translation>
    </message>
    <message>
        <source>Root mean square of the acceleration, mm/s²</source>
        <translation>Среднеквадратичное ускорение, мм/с²</translation>
    </message>
    <message>
        <source>Temperature, °C</source>
        <translation>Температура, °C</translation>
    </message>
    <message>
        <source>Frequency of the thermostat&apos;s fan, revolutions per second</source>
        <translation>Частота вентилятора термостата, об./с</translation>
    </message>
    <message>
        <source>Power of the thermostat&apos;s heater, %</source>
        <translation>Мощность нагревательного элемента термостата, %</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Датчик</translation>
    </message>
    <message>
        <source>Mx, °</source>
        <translation>Mx, °</translation>
    </message>
    <message>
        <source>My, °</source>
        <translation>My, °</translation>
    </message>
    <message>
        <source>Amax, mm/s²</source>
        <translation>Amax, мм/с²</translation>
    </message>
    <message>
        <source>Arms, mm/s²</source>
        <translation>Arms, мм/с²</translation>
    </message>
    <message>
        <source>T, °C</source>
        <translation>T, °C</translation>
    </message>
    <message>
        <source>Frequency, rev/s</source>
        <translation>Частота, об./с</translation>
    </message>
    <message>
        <source>P, %</source>
        <translation>P, %</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>Статус</translation>
    </message>
    <message>
        <source>%1 arc-seconds</source>
        <translation>%1 угл. сек.</translation>
    </message>
    <message>
        <source>along X %1, along Y %2 mm/s²</source>
        <translation>по X %1, по Y %2 мм/с²</translation>
    </message>
    <message>
        <source>Logical name of the sensor: number, type, place, address</source>
        <translation>Логическое название датчика: номер, тип, место установки, адрес</translation>
    </message>
</context>
<context>
    <name>gorizont::SensorsPage</name>
    <message>
        <source>The configuration file lists no sensors.</source>
        <translation>В файле настроек нет датчиков.</translation>
    </message>
</context>
<context>
    <name>gorizont::SerialLine</name>
    <message>
        <source>there is no such device</source>
        <translation>нет такого устройства</translation>
    </message>
    <message>
        <source>the adapter does not know RS485=1</source>
        <translation>адаптер не поддерживает RS485=1</translation>
    </message>
</context>
<context>
    <name>gorizont::ServiceDesk</name>
    <message>
        <source>Select a port in the tree first.</source>
        <translation>Сначала выберите порт в дереве.</translation>
    </message>
    <message>
        <source>The port is off (On=0).</source>
        <translation>Порт выключен (On=0).</translation>
    </message>
    <message>
        <source>The port is in service already.</source>
        <translation>Порт уже в сервисном режиме.</translation>
    </message>
    <message>
        <source>The port is not open.</source>
        <translation>Порт не открыт.</translation>
    </message>
    <message>
        <source>There is no %1 in the list of this port.</source>
        <translation>В списке датчиков этого порта нет %1.</translation>
    </message>
    <message>
        <source>%1 goes into service mode: the monitoring of all its sensors is suspended.</source>
        <translation>%1 переводится в сервисный режим: мониторинг всех его датчиков приостанавливается.</translation>
    </message>
    <message>
        <source>Until the service window is closed, screens, files and clients keep the last values, marked as not valid. The other ports go on.</source>
        <translation>Пока окно настройки открыто, на экране, в файлах и у клиентов остаются последние значения с признаком недостоверности. Остальные порты работают.</translation>
    </message>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;ОК</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>О&amp;тмена</translation>
    </message>
</context>
<context>
    <name>gorizont::ServiceDialog</name>
    <message>
        <source>%1, the program ended before the answer came: whether it was written is not known, check it</source>
        <translation>%1, программа завершилась до ответа датчика: записано или нет, неизвестно, проверьте</translation>
    </message>
    <message>
        <source>The port goes into service mode…</source>
        <translation>Порт переводится в сервисный режим…</translation>
    </message>
    <message>
        <source>The window closes as soon as the sensor has answered.</source>
        <translation>Окно закроется, как только датчик ответит.</translation>
    </message>
    <message>
        <source>&amp;Leave</source>
        <translation>В&amp;ыйти</translation>
    </message>
    <message>
        <source>Service has ended, the sensors of the port are polled again.</source>
        <translation>Сервисный режим завершён, опрос датчиков порта продолжается.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Н&amp;е применять</translation>
    </message>
    <message>
        <source>%1, %2 address %3: %4</source>
        <translation>%1, %2 адрес %3: %4</translation>
    </message>
    <message>
        <source>Ex&amp;it</source>
        <translation>&amp;Выход</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>Верн&amp;уться</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
</context>
<context>
    <name>gorizont::ServiceSession</name>
    <message>
        <source>The port is in service already.</source>
        <translation>Порт уже в сервисном режиме.</translation>
    </message>
    <message>
        <source>The program is about to end.</source>
        <translation>Программа завершает работу.</translation>
    </message>
    <message>
        <source>The port is not open. Check the adapter and its cable.</source>
        <translation>Порт не открыт. Проверьте адаптер и кабель.</translation>
    </message>
    <message>
        <source>%1 is gone (%2). Service has ended; polling goes on as soon as the port is back.</source>
        <translation>%1 пропал (%2). Сервисный режим завершён; опрос продолжится, когда порт появится.</translation>
    </message>
</context>
<context>
    <name>gorizont::ServiceText</name>
    <message>
        <source>no answer</source>
        <translation>нет ответа</translation>
    </message>
    <message>
        <source>the answers are damaged</source>
        <translation>ответы повреждены</translation>
    </message>
    <message>
        <source>the answer is not the expected one</source>
        <translation>ответ не тот, что ожидался</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>отказ</translation>
    </message>
    <message>
        <source>the port is gone</source>
        <translation>порт пропал</translation>
    </message>
    <message>
        <source>broken off</source>
        <translation>прервано</translation>
    </message>
    <message>
        <source>Settings of %1 sensors</source>
        <translation>Настройка датчиков %1</translation>
    </message>
    <message>
        <source>Settings of %1 sensors on %2</source>
        <translation>Настройка датчиков %1 на %2</translation>
    </message>
    <message>
        <source>No sensor of the configuration file has this address; add one to [Port%1] so that it is polled.</source>
        <translation>В файле конфигурации нет датчика с прежним адресом; чтобы датчик опрашивался, добавьте его в [Port%1].</translation>
    </message>
    <message>
        <source>Write adr%2=%3 into [Port%1] of the configuration file and start the program again: until then it polls address %4.</source>
        <translation>Исправьте в файле конфигурации [Port%1] adr%2=%3 и перезапустите программу: до этого она опрашивает адрес %4.</translation>
    </message>
    <message>
        <source>%1 (N %2 in the ini)</source>
        <translation>%1 (в ini: N %2)</translation>
    </message>
    <message>
        <source>Settings of the weather station %1</source>
        <translation>Настройка метеостанции %1</translation>
    </message>
    <message>
        <source>Settings of the weather station %1 on %2</source>
        <translation>Настройка метеостанции %1 на %2</translation>
    </message>
    <message>
        <source>Settings of the module L-VIMS</source>
        <translation>Настройка модуля L-VIMS</translation>
    </message>
    <message>
        <source>Settings of the module L-VIMS on %1</source>
        <translation>Настройка модуля L-VIMS на %1</translation>
    </message>
</context>
<context>
    <name>gorizont::Simulator</name>
    <message>
        <source>The ini that lists the sensors.</source>
        <translation>Файл настроек со списком датчиков.</translation>
    </message>
    <message>
        <source>Folder for the links COMn.</source>
        <translation>Папка для ссылок COMn.</translation>
    </message>
    <message>
        <source>Another building.</source>
        <translation>Другое здание.</translation>
    </message>
    <message>
        <source>Something that goes wrong.</source>
        <translation>Неисправность.</translation>
    </message>
    <message>
        <source>--config FILE and --ports DIR are needed</source>
        <translation>нужны --config FILE и --ports DIR</translation>
    </message>
    <message>
        <source>--fault %1 is not understood; --help lists what can go wrong</source>
        <translation>--fault %1 непонятно; --help перечисляет неисправности</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>не удаётся создать папку %1</translation>
    </message>
    <message>
        <source>Plays the sensors of an ini file: every port becomes a pty linked as DIR/COMn, a port with Device=tcp://127.0.0.1:port listens there.

Faults, each KIND=VALUE[@FROM[-TO]] with times in seconds since the start:
  silent=N     the sensor with site number N does not answer
  crc=P        P % of the answers have a wrong byte
  garbage=P    P % of the answers come after garbage
  pieces=P     P % of the answers come in pieces
  late=P       P % of the answers come 1.5 s late
  reboot=N     the sensor N restarts, once at FROM
  overrun=N    the ring of the sensor N is overwritten, once at FROM
  gone=n:S     the port COMn is gone for S seconds, once at FROM</source>
        <translation>Имитирует датчики файла настроек: каждый порт становится псевдотерминалом со ссылкой DIR/COMn, порт с Device=tcp://127.0.0.1:port принимает там соединения.

Неисправности, каждая KIND=VALUE[@FROM[-TO]], время в секундах от запуска:
  silent=N     датчик с номером N на объекте не отвечает
  crc=P        P % ответов с неверным байтом
  garbage=P    P % ответов приходят после мусора
  pieces=P     P % ответов приходят по частям
  late=P       P % ответов опаздывают на 1,5 с
  reboot=N     датчик N перезагружается один раз в момент FROM
  overrun=N    буфер датчика N перезаписывается один раз в момент FROM
  gone=n:S     порт COMn пропадает на S секунд один раз в момент FROM</translation>
    </message>
</context>
<context>
    <name>gorizont::SiteTree</name>
    <message>
        <source>Find a sensor (Ctrl+F)</source>
        <translation>Найти датчик (Ctrl+F)</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>Ничего не найдено</translation>
    </message>
</context>
<context>
    <name>gorizont::SiteTreeModel</name>
    <message>
        <source>Server</source>
        <translation>Сервер</translation>
    </message>
</context>
<context>
    <name>gorizont::SourceFile</name>
    <message>
        <source>The line is left out.</source>
        <translation>Строка пропущена.</translation>
    </message>
    <message>
        <source>%1 is no channel: a1…a64, f1, d1…d32, p1…p32, v1…v4, o1…o32, rate or record are expected.</source>
        <translation>%1 — не канал: ожидается a1…a64, f1, d1…d32, p1…p32, v1…v4, o1…o32, rate или record.</translation>
    </message>
    <message numerus="yes">
        <source>%n number(s) are expected here.</source>
        <translation>
            <numerusform>Здесь ожидается %n число.</numerusform>
            <numerusform>Здесь ожидаются %n числа.</numerusform>
            <numerusform>Здесь ожидается %n чисел.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 — не число.</translation>
    </message>
    <message>
        <source>%1 is not greater than 0.</source>
        <translation>%1 не больше 0.</translation>
    </message>
    <message>
        <source>At most %1 Hz are possible.</source>
        <translation>Возможно не больше %1 Гц.</translation>
    </message>
    <message>
        <source>The name of the recorded file is missing.</source>
        <translation>Нет имени записанного файла.</translation>
    </message>
    <message>
        <source>Only `once` may follow the name of the file.</source>
        <translation>После имени файла может стоять только `once`.</translation>
    </message>
    <message>
        <source>An output goes to a file: `file PATH` is expected.</source>
        <translation>Выход связывается с файлом: ожидается `file ПУТЬ`.</translation>
    </message>
    <message>
        <source>%1 is no signal: constant, sine, noise, drop, square, output, vane, iio or file are expected.</source>
        <translation>%1 — не сигнал: ожидается constant, sine, noise, drop, square, output, vane, iio или file.</translation>
    </message>
    <message>
        <source>`vane` and the channels v1…v4 go together.</source>
        <translation>`vane` бывает только у каналов v1…v4, а у них — только он.</translation>
    </message>
    <message>
        <source>An output has a bit from 0 to 31.</source>
        <translation>Бит выхода — от 0 до 31.</translation>
    </message>
    <message>
        <source>Such a channel cannot come from there.</source>
        <translation>Такой канал оттуда взять нельзя.</translation>
    </message>
    <message>
        <source>`iio FOLDER INPUT` is expected.</source>
        <translation>Ожидается `iio ПАПКА ВХОД`.</translation>
    </message>
    <message>
        <source>`file PATH` is expected.</source>
        <translation>Ожидается `file ПУТЬ`.</translation>
    </message>
    <message>
        <source>%1 is no input of a device.</source>
        <translation>%1 — не номер входа устройства.</translation>
    </message>
</context>
<context>
    <name>gorizont::SourceWatch</name>
    <message>
        <source>Source %1 works again.</source>
        <translation>Источник «%1» снова работает.</translation>
    </message>
    <message>
        <source>it has said nothing for %1 s</source>
        <translation>он молчит дольше %1 с</translation>
    </message>
    <message>
        <source>Source %1 has failed: %2. Its parameters have no value; it is started again every %3 s.</source>
        <translation>Источник «%1» отказал: %2. У его параметров нет значения; каждые %3 с он запускается снова.</translation>
    </message>
</context>
<context>
    <name>gorizont::Sources</name>
    <message>
        <source>simulated signals</source>
        <translation>имитируемые сигналы</translation>
    </message>
</context>
<context>
    <name>gorizont::SpanPage</name>
    <message>
        <source>Sensor</source>
        <translation>Датчик</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Сейчас</translation>
    </message>
    <message>
        <source>The span ends at the present moment and moves on with it</source>
        <translation>Промежуток кончается текущим моментом и движется вместе с ним</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The archive does not answer. The journal says why.</source>
        <translation>Архив не отвечает. Причина указана в журнале.</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Чтение…</translation>
    </message>
</context>
<context>
    <name>gorizont::SpectrumPlot</name>
    <message>
        <source>of the waveform</source>
        <translation>по выборке</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Частота, Гц</translation>
    </message>
    <message>
        <source>Density, (%1)²/Hz</source>
        <translation>Плотность, (%1)²/Гц</translation>
    </message>
    <message>
        <source>Amplitude, %1</source>
        <translation>Амплитуда, %1</translation>
    </message>
</context>
<context>
    <name>gorizont::SpoolFile</name>
    <message>
        <source>%1 is full</source>
        <translation>%1 заполнен</translation>
    </message>
</context>
<context>
    <name>gorizont::Startup</name>
    <message>
        <source>%1 cannot be read (%2). Check the name and the rights of the file.</source>
        <translation>Не удаётся прочитать %1 (%2). Проверьте имя и права доступа к файлу.</translation>
    </message>
    <message>
        <source>The folder %1 for the data cannot be made. Choose another one with --data.</source>
        <translation>Не удаётся создать папку данных %1. Задайте другую ключом --data.</translation>
    </message>
</context>
<context>
    <name>gorizont::StatePanel</name>
    <message>
        <source>Ports</source>
        <translation>Порты</translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation>Датчики</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Порт</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Датчик</translation>
    </message>
    <message>
        <source>Clients</source>
        <translation>Клиенты</translation>
    </message>
</context>
<context>
    <name>gorizont::StationApplication</name>
    <message>
        <source>The log is written again.</source>
        <translation>Журнал снова пишется.</translation>
    </message>
    <message>
        <source>The log cannot be written: %1</source>
        <translation>Журнал не удаётся записать: %1</translation>
    </message>
</context>
<context>
    <name>gorizont::StationFilesModel</name>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Строка</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Поле</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Что не так</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Что сделано</translation>
    </message>
</context>
<context>
    <name>gorizont::StationMain</name>
    <message>
        <source>There is no folder %1. Name the one with ACK.INI with --config.</source>
        <translation>Нет папки %1. Укажите папку с ACK.INI: --config.</translation>
    </message>
    <message>
        <source>The folder %1 for the data cannot be made. Choose another one with --data.</source>
        <translation>Папку %1 для данных не удаётся создать. Укажите другую: --data.</translation>
    </message>
    <message>
        <source>A station already works with the folder %1. End that program, or give this one a folder of its own with --data.</source>
        <translation>С папкой %1 уже работает станция. Завершите ту программу или дайте этой собственную папку: --data.</translation>
    </message>
</context>
<context>
    <name>gorizont::StationOptions</name>
    <message>
        <source>A weather station: measures, corrects, averages, keeps records and answers dispatchers.

SIGHUP reads the files of the station again, SIGINT and SIGTERM end the program.</source>
        <translation>Метеостанция: измеряет, вносит поправки, осредняет, ведёт записи и отвечает диспетчерам.

SIGHUP — перечитать файлы станции, SIGINT и SIGTERM — завершить программу.</translation>
    </message>
    <message>
        <source>The folder with ACK.INI and the other files of the station.</source>
        <translation>Папка с ACK.INI и остальными файлами станции.</translation>
    </message>
    <message>
        <source>Where records and the log go; default: the folder of the configuration.</source>
        <translation>Куда идут записи и журнал; по умолчанию в папку файлов станции.</translation>
    </message>
    <message>
        <source>Port number n is opened as DIR/COMn.</source>
        <translation>Порт с номером n открывается как DIR/COMn.</translation>
    </message>
    <message>
        <source>Waits for dispatchers over TCP too: PORT for this computer only, ADDRESS:PORT for others. May be given several times.</source>
        <translation>Ждать диспетчеров и по TCP: PORT — только с этого компьютера, ADDRESS:PORT — с других. Можно указать несколько раз.</translation>
    </message>
    <message>
        <source>Without effect: the station never has a window.</source>
        <translation>Ничего не меняет: окна у станции нет.</translation>
    </message>
    <message>
        <source>Prints every second as one line of JSON.</source>
        <translation>Печатать каждую секунду одной строкой JSON.</translation>
    </message>
    <message>
        <source>A dispatcher may set the clock of this computer; else the station keeps a clock of its own.</source>
        <translation>Диспетчер может ставить часы этого компьютера; иначе станция ведёт собственные.</translation>
    </message>
    <message>
        <source>Language of the program.</source>
        <translation>Язык программы.</translation>
    </message>
    <message>
        <source>Prints this.</source>
        <translation>Напечатать эту справку.</translation>
    </message>
    <message>
        <source>Prints the version.</source>
        <translation>Напечатать версию.</translation>
    </message>
    <message>
        <source>Unexpected argument: %1</source>
        <translation>Лишний аргумент: %1</translation>
    </message>
    <message>
        <source>--config DIR is needed, the folder with ACK.INI and the other files of the station</source>
        <translation>нужен --config DIR, папка с ACK.INI и остальными файлами станции</translation>
    </message>
    <message>
        <source>--lang takes ru or en, not %1</source>
        <translation>--lang принимает ru или en, а не %1</translation>
    </message>
    <message>
        <source>--listen takes PORT or ADDRESS:PORT, with an address in digits, not %1</source>
        <translation>--listen принимает PORT или ADDRESS:PORT с адресом из цифр, а не %1</translation>
    </message>
</context>
<context>
    <name>gorizont::StationPlan</name>
    <message>
        <source>extra</source>
        <translation>дополнение</translation>
    </message>
    <message>
        <source>ACK.PAR has no parameter %1.</source>
        <translation>В ACK.PAR нет параметра %1.</translation>
    </message>
    <message>
        <source>This value of object %1 is not taken over.</source>
        <translation>Это значение объекта %1 не берётся.</translation>
    </message>
    <message>
        <source>%1 is no data command, 1 to 8.</source>
        <translation>%1 — не команда данных, 1…8.</translation>
    </message>
    <message>
        <source>Object %1 is asked with command %2.</source>
        <translation>Объект %1 опрашивается командой %2.</translation>
    </message>
    <message>
        <source>%1 is no source: file:NAME or iio:FOLDER are.</source>
        <translation>%1 — не источник: ожидается file:ИМЯ или iio:ПАПКА.</translation>
    </message>
    <message>
        <source>Only ACK.SRC gives values to this board.</source>
        <translation>Значения этой плате даёт только ACK.SRC.</translation>
    </message>
</context>
<context>
    <name>gorizont::StatusText</name>
    <message>
        <source>%1 No. %2 (%3, address %4)</source>
        <translation>%1 № %2 (%3, адрес %4)</translation>
    </message>
    <message>
        <source>No errors</source>
        <translation>Нет ошибок</translation>
    </message>
    <message>
        <source>The port is off</source>
        <translation>Порт выключен</translation>
    </message>
    <message>
        <source>Port error</source>
        <translation>Ошибка порта</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Не отвечает</translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation>Ошибки CRC</translation>
    </message>
    <message>
        <source>The transducer does not answer</source>
        <translation>Первичный преобразователь не отвечает</translation>
    </message>
    <message>
        <source>CRC errors of the transducer</source>
        <translation>Ошибки CRC первичного преобразователя</translation>
    </message>
    <message>
        <source>The transducer is out of range</source>
        <translation>Первичный преобразователь вне диапазона</translation>
    </message>
    <message>
        <source>The temperature sensor does not work</source>
        <translation>Не работает датчик температуры</translation>
    </message>
    <message>
        <source>The temperature sensor is out of range</source>
        <translation>Датчик температуры вне диапазона</translation>
    </message>
    <message>
        <source>The fan does not work</source>
        <translation>Не работает вентилятор</translation>
    </message>
    <message>
        <source>The thermostat takes too long to settle</source>
        <translation>Время установления температуры термостата превысило допустимое</translation>
    </message>
    <message>
        <source>Unknown error</source>
        <translation>Неизвестная ошибка</translation>
    </message>
    <message>
        <source>The supply voltage of the station&apos;s sensors is bad</source>
        <translation>Напряжение питания датчиков станции не в норме</translation>
    </message>
</context>
<context>
    <name>gorizont::SysfsSource</name>
    <message>
        <source>%1 holds no number</source>
        <translation>в %1 нет числа</translation>
    </message>
    <message>
        <source>inputs of the system</source>
        <translation>входы системы</translation>
    </message>
    <message>
        <source>there is no folder %1</source>
        <translation>нет папки %1</translation>
    </message>
</context>
<context>
    <name>gorizont::TableView</name>
    <message>
        <source>Copy the &amp;cell</source>
        <translation>Копировать &amp;ячейку</translation>
    </message>
    <message>
        <source>Copy the &amp;rows</source>
        <translation>Копировать &amp;строки</translation>
    </message>
    <message>
        <source>Copy the &amp;table</source>
        <translation>Копировать &amp;таблицу</translation>
    </message>
    <message>
        <source>Restore the columns</source>
        <translation>Восстановить столбцы</translation>
    </message>
</context>
<context>
    <name>gorizont::TrayIcon</name>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Развернуть</translation>
    </message>
    <message>
        <source>E&amp;xit</source>
        <translation>В&amp;ыход</translation>
    </message>
    <message>
        <source>Messages for the dispatcher: %1</source>
        <translation>Сообщений для диспетчера: %1</translation>
    </message>
</context>
<context>
    <name>gorizont::TrendsPage</name>
    <message>
        <source>Nothing is drawn yet. Tick values in the list on the left, or drag a sensor from the tree into this field.</source>
        <translation>Пока ничего не показано. Отметьте величины в списке слева или перетащите сюда датчик из дерева.</translation>
    </message>
    <message>
        <source>There are no values in this span. Choose a longer span, or move to another time by dragging.</source>
        <translation>За это время значений нет. Выберите больший промежуток или перейдите к другому времени перетаскиванием.</translation>
    </message>
    <message>
        <source>The archive does not answer; only what comes now is drawn. The journal says why.</source>
        <translation>Архив не отвечает; показано только то, что приходит сейчас. Причина указана в журнале.</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Чтение…</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>График</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Сейчас</translation>
    </message>
    <message>
        <source>The right end is the present moment and moves on with it (End)</source>
        <translation>Правый край — текущий момент и движется вместе с ним (End)</translation>
    </message>
    <message>
        <source>In what angles are drawn</source>
        <translation>В чём показаны углы</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>градусы</translation>
    </message>
    <message>
        <source>arc-seconds</source>
        <translation>угл. секунды</translation>
    </message>
    <message>
        <source>Save what is seen</source>
        <translation>Сохранить показанное</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder, or close the program that has the file open.</source>
        <translation>Не удаётся записать %1. Выберите другую папку или закройте программу, в которой открыт файл.</translation>
    </message>
    <message>
        <source>Keep the layout</source>
        <translation>Сохранить набор</translation>
    </message>
    <message>
        <source>Curves and span are kept under this name:</source>
        <translation>Кривые и промежуток сохраняются под именем:</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Удалить</translation>
    </message>
    <message>
        <source>&amp;Keep as…</source>
        <translation>&amp;Сохранить как…</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Курсоры</translation>
    </message>
    <message>
        <source>Two lines to read values, differences and slopes; drag them, or move A with Ctrl and B with Shift and the arrow keys</source>
        <translation>Две линии для отсчёта значений, разностей и наклонов; перетаскиваются мышью, стрелками с Ctrl движется A, с Shift — B</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>Наборы</translation>
    </message>
    <message>
        <source>&amp;Picture (PNG)…</source>
        <translation>&amp;Рисунок (PNG)…</translation>
    </message>
    <message>
        <source>&amp;Document (PDF)…</source>
        <translation>&amp;Документ (PDF)…</translation>
    </message>
    <message>
        <source>Table for &amp;Excel (CSV)…</source>
        <translation>Таблица для &amp;Excel (CSV)…</translation>
    </message>
    <message>
        <source>Table for p&amp;rograms (CSV, ISO 8601)…</source>
        <translation>Таблица для &amp;программ (CSV, ISO 8601)…</translation>
    </message>
    <message>
        <source>%1   Old files: %2</source>
        <translation>%1   Старые файлы: %2</translation>
    </message>
    <message>
        <source>Open old files: the folder History</source>
        <translation>Открыть старые файлы: папка History</translation>
    </message>
    <message>
        <source>The records in %1 hold another number of sensors than this configuration, so nobody knows whose they are. Start the program with the configuration they were made with.</source>
        <translation>В записях папки %1 другое число датчиков, чем в этой конфигурации, поэтому неизвестно, чьи они. Запустите программу с той конфигурацией, с которой они сделаны.</translation>
    </message>
    <message>
        <source>There are no old records in %1. Choose the folder with files like 2018_02_data.txt.</source>
        <translation>В папке %1 нет старых записей. Выберите папку с файлами вида 2018_02_data.txt.</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Файлы</translation>
    </message>
    <message>
        <source>Back to the archive</source>
        <translation>Вернуться к архиву</translation>
    </message>
    <message>
        <source>&amp;Open old files…</source>
        <translation>&amp;Открыть старые файлы…</translation>
    </message>
</context>
<context>
    <name>gorizont::UsmDevicePanel</name>
    <message>
        <source>About the device</source>
        <translation>Об устройстве</translation>
    </message>
    <message>
        <source>%1, not an УСМ-ИСН</source>
        <translation>%1, не УСМ-ИСН</translation>
    </message>
    <message>
        <source>Serial number:</source>
        <translation>Серийный номер:</translation>
    </message>
    <message>
        <source>Type:</source>
        <translation>Тип:</translation>
    </message>
    <message>
        <source>Calibrated on:</source>
        <translation>Дата калибровки:</translation>
    </message>
    <message>
        <source>Calibrations so far:</source>
        <translation>Счётчик калибровок:</translation>
    </message>
    <message>
        <source>Program of:</source>
        <translation>Программа от:</translation>
    </message>
    <message>
        <source>Channels:</source>
        <translation>Каналы:</translation>
    </message>
    <message>
        <source>Measuring now</source>
        <translation>Измерение сейчас</translation>
    </message>
    <message>
        <source>Keep it in the memory of the device</source>
        <translation>Записать и в память прибора</translation>
    </message>
    <message>
        <source>Takes two of the %1 records; the oldest ones are overwritten.</source>
        <translation>Займёт две записи из %1; самые старые перезаписываются.</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>Из&amp;мерить</translation>
    </message>
    <message>
        <source>Up to 1.5 s an axis</source>
        <translation>До 1,5 с на ось</translation>
    </message>
</context>
<context>
    <name>gorizont::UsmDialog</name>
    <message>
        <source>Records are still being downloaded. Break it off? What the device has sent meanwhile only &lt;Download all&gt; brings again.</source>
        <translation>Записи ещё загружаются. Прервать? То, что прибор за это время послал, ещё раз вернёт только &lt;Загрузить все&gt;.</translation>
    </message>
    <message>
        <source>The recorder is still being woken. Break it off?</source>
        <translation>Регистратор ещё не разбужен. Прервать?</translation>
    </message>
    <message>
        <source>Reading sensor %1…</source>
        <translation>Чтение параметров датчика %1…</translation>
    </message>
    <message>
        <source>Sensor %1 cannot be read: %2.</source>
        <translation>Параметры датчика %1 не прочитаны: %2.</translation>
    </message>
    <message>
        <source>This is another device of the УСМ series (type %1); nothing of it can be set here.</source>
        <translation>Это другой прибор серии УСМ (тип %1); здесь он не настраивается.</translation>
    </message>
    <message>
        <source>Looking for %1…</source>
        <translation>Поиск %1…</translation>
    </message>
    <message>
        <source>The device measures…</source>
        <translation>Прибор измеряет…</translation>
    </message>
    <message>
        <source>The device keeps what it measured.</source>
        <translation>Измеренное записано в память прибора.</translation>
    </message>
    <message>
        <source>The first measurement has to lie in the future. Nothing was sent.</source>
        <translation>Первое измерение должно быть в будущем. Ничего не послано.</translation>
    </message>
    <message>
        <source>It sleeps, measures every %1 s and answers nobody until it is woken here, which takes up to two minutes, or is without power for more than a minute.</source>
        <translation>Он спит, измеряет каждые %1 с и никому не отвечает, пока его не разбудят здесь (до двух минут) или пока он не останется без питания больше минуты.</translation>
    </message>
    <message>
        <source>Make ALL devices of the УСМ series on this line recorders?</source>
        <translation>Перевести ВСЕ приборы серии УСМ на этой линии в режим автономного регистратора?</translation>
    </message>
    <message>
        <source>Make sensor %1 a recorder?</source>
        <translation>Перевести датчик %1 в режим автономного регистратора?</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Начать</translation>
    </message>
    <message>
        <source>recorder mode</source>
        <translation>режим автономного регистратора</translation>
    </message>
    <message>
        <source>Writing: %1…</source>
        <translation>Запись: %1…</translation>
    </message>
    <message>
        <source>Sensor %1: %2</source>
        <translation>Датчик %1: %2</translation>
    </message>
    <message>
        <source>Every recorder on the line is being woken; nobody answers that…</source>
        <translation>Все регистраторы на линии выводятся из режима; на это никто не отвечает…</translation>
    </message>
    <message>
        <source>Waiting until recorder %1 listens…</source>
        <translation>Ожидание, пока регистратор %1 слушает линию…</translation>
    </message>
    <message>
        <source>it does not record any more</source>
        <translation>выведен из режима автономного регистратора</translation>
    </message>
    <message>
        <source>waking was stopped; it may still record</source>
        <translation>вывод из режима остановлен; прибор, возможно, всё ещё регистратор</translation>
    </message>
    <message>
        <source>StopCycle was sent for two minutes. Scan the line.</source>
        <translation>StopCycle посылался две минуты. Просканируйте линию.</translation>
    </message>
    <message>
        <source>it did not answer for two minutes. Check its address and power; more than a minute without power ends the recorder mode too</source>
        <translation>не ответил за две минуты. Проверьте адрес и питание; больше минуты без питания тоже завершают режим регистратора</translation>
    </message>
    <message>
        <source>is not written here; save the records as CSV</source>
        <translation>здесь не ведётся; сохраните записи в CSV</translation>
    </message>
    <message>
        <source>keeps nothing of it: no sensor of the configuration file has this address</source>
        <translation>не сохраняет: у датчиков файла конфигурации нет такого адреса</translation>
    </message>
    <message>
        <source>keeps nothing of it: the configuration file expects %1 at this address (SND3%2)</source>
        <translation>не сохраняет: по этому адресу файл конфигурации ждёт прибор %1 (SND3%2)</translation>
    </message>
    <message>
        <source>keeps each record once, for sensor N %1</source>
        <translation>сохраняет каждую запись один раз, для датчика N %1</translation>
    </message>
    <message>
        <source>Downloading records, channel %1…</source>
        <translation>Загрузка записей, канал %1…</translation>
    </message>
    <message>
        <source>The transfer broke off; it goes on with all records, those known are passed over.</source>
        <translation>Передача оборвалась; запрошены все записи, уже полученные пропускаются.</translation>
    </message>
    <message numerus="yes">
        <source>%n new record(s)</source>
        <translation>
            <numerusform>%n новая запись</numerusform>
            <numerusform>%n новые записи</numerusform>
            <numerusform>%n новых записей</numerusform>
        </translation>
    </message>
    <message>
        <source>%1; the download was stopped. The device may go on sending for some minutes; the next download asks for all records.</source>
        <translation>%1; загрузка остановлена. Прибор может передавать ещё несколько минут; следующая загрузка запросит все записи.</translation>
    </message>
    <message>
        <source>%1; the device does not understand the request for its records.</source>
        <translation>%1; прибор не понял запрос записей.</translation>
    </message>
    <message>
        <source>%1; the download broke off (%2). The next one asks for all records and goes on with those missing.</source>
        <translation>%1; загрузка оборвалась (%2). Следующая запросит все записи и продолжит с недостающих.</translation>
    </message>
    <message>
        <source>Save the records</source>
        <translation>Сохранить записи</translation>
    </message>
    <message numerus="yes">
        <source>%n record(s) saved</source>
        <translation>
            <numerusform>Сохранена %n запись</numerusform>
            <numerusform>Сохранены %n записи</numerusform>
            <numerusform>Сохранено %n записей</numerusform>
        </translation>
    </message>
    <message>
        <source>The records were not saved (%1). Choose another folder.</source>
        <translation>Записи не сохранены (%1). Выберите другую папку.</translation>
    </message>
    <message>
        <source>Give ALL devices of the УСМ series on this line the address %1? Several with one address cannot be asked any more. Go on only if there is just one.</source>
        <translation>Установить ВСЕМ приборам серии УСМ на этой линии адрес %1? Несколько приборов с одним адресом опросить нельзя. Продолжайте, только если прибор один.</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>За&amp;пись</translation>
    </message>
    <message>
        <source>new address %1</source>
        <translation>новый адрес %1</translation>
    </message>
    <message>
        <source>Give sensor %1 the address %2?</source>
        <translation>Установить датчику %1 адрес %2?</translation>
    </message>
    <message>
        <source>Give ALL devices of the УСМ series on this line the port settings %1? None of them answers; this port does not hear them any more until its own settings follow.</source>
        <translation>Установить ВСЕМ приборам серии УСМ на этой линии параметры порта %1? Ни один не ответит; порт не услышит их, пока не изменены его собственные параметры.</translation>
    </message>
    <message>
        <source>port settings %1</source>
        <translation>параметры порта %1</translation>
    </message>
    <message>
        <source>Give sensor %1 the port settings %2? This port does not hear it any more until its own settings follow.</source>
        <translation>Установить датчику %1 параметры порта %2? Порт не услышит его, пока не изменены его собственные параметры.</translation>
    </message>
    <message>
        <source>%1, sent to all devices; nobody answers that. Scan the line.</source>
        <translation>%1: послано всем приборам, на это никто не отвечает. Просканируйте линию.</translation>
    </message>
    <message>
        <source>%1, not sent: %2</source>
        <translation>%1, не послано: %2</translation>
    </message>
    <message>
        <source>The line is silent, so that devices that hang restart…</source>
        <translation>Линия молчит, чтобы зависшие приборы перезапустились…</translation>
    </message>
    <message>
        <source>The line was silent; devices that hung have restarted.</source>
        <translation>Линия молчала; зависшие приборы перезапустились.</translation>
    </message>
</context>
<context>
    <name>gorizont::UsmForm</name>
    <message>
        <source>Device</source>
        <translation>Прибор</translation>
    </message>
    <message>
        <source>Address and port</source>
        <translation>Адрес и порт</translation>
    </message>
    <message>
        <source>Recorder</source>
        <translation>Регистратор</translation>
    </message>
    <message>
        <source>Records</source>
        <translation>Записи</translation>
    </message>
    <message>
        <source>Exchange</source>
        <translation>Параметры обмена</translation>
    </message>
    <message>
        <source>One or several serial numbers with blanks between them. Up to 3 s each.</source>
        <translation>Один или несколько серийных номеров через пробел. До 3 с на каждый.</translation>
    </message>
    <message>
        <source>&amp;Find</source>
        <translation>&amp;Найти</translation>
    </message>
    <message>
        <source>Add&amp;ress on the line:</source>
        <translation>&amp;Адрес на линии:</translation>
    </message>
    <message>
        <source>Find by serial n&amp;umber:</source>
        <translation>Поиск по серийному номе&amp;ру:</translation>
    </message>
</context>
<context>
    <name>gorizont::UsmRecorderPanel</name>
    <message>
        <source>For all devices on the line (none of them answers)</source>
        <translation>Для всех приборов на линии (ни один не ответит)</translation>
    </message>
    <message>
        <source>A recorder sleeps, measures by its clock and answers nobody; polling shows it as one that does not answer. More than a minute without power ends this mode too.</source>
        <translation>Автономный регистратор спит, измеряет по своим часам и никому не отвечает; опрос показывает, что ответа нет. Больше минуты без питания тоже завершают этот режим.</translation>
    </message>
    <message>
        <source>Recorder mode</source>
        <translation>Режим автономного регистратора</translation>
    </message>
    <message>
        <source>So that several devices do not measure at the same time</source>
        <translation>Чтобы несколько приборов не измеряли одновременно</translation>
    </message>
    <message>
        <source>&amp;Begin to record</source>
        <translation>Начать ре&amp;гистрацию</translation>
    </message>
    <message>
        <source>First measurement (local time):</source>
        <translation>Первое измерение (местное время):</translation>
    </message>
    <message>
        <source>Period, s:</source>
        <translation>Период, с:</translation>
    </message>
    <message>
        <source>Delay before each, s:</source>
        <translation>Задержка перед каждым, с:</translation>
    </message>
    <message>
        <source>End of the recorder mode</source>
        <translation>Вывод из режима регистратора</translation>
    </message>
    <message>
        <source>A recorder listens now and then for a second: this takes up to two minutes.</source>
        <translation>Регистратор время от времени слушает линию одну секунду: это занимает до двух минут.</translation>
    </message>
    <message>
        <source>Address of the recorder:</source>
        <translation>Адрес регистратора:</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>Сто&amp;п</translation>
    </message>
    <message>
        <source>&amp;Wake</source>
        <translation>Разб&amp;удить</translation>
    </message>
</context>
<context>
    <name>gorizont::UsmRecordsPanel</name>
    <message>
        <source>Download the &amp;new ones</source>
        <translation>Загрузить нов&amp;ые</translation>
    </message>
    <message>
        <source>Download &amp;all</source>
        <translation>Загрузить вс&amp;е</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>Сто&amp;п</translation>
    </message>
    <message>
        <source>Save as &amp;CSV…</source>
        <translation>Сохранить в &amp;CSV…</translation>
    </message>
    <message>
        <source>Those that were not read before. The device counts as read what it has sent.</source>
        <translation>Те, что ещё не считывались. Прибор считает прочитанным всё, что послал.</translation>
    </message>
    <message>
        <source>Up to %1 records; some minutes at 9600, in which the other sensors of the port are not asked.</source>
        <translation>До %1 записей; на 9600 — несколько минут, остальные датчики порта в это время не опрашиваются.</translation>
    </message>
    <message>
        <source>How many numbers of measurements (MeasID) are missing between the first and the last one</source>
        <translation>Сколько номеров измерений (MeasID) отсутствует между первым и последним</translation>
    </message>
    <message>
        <source>Records here:</source>
        <translation>Загружено записей:</translation>
    </message>
    <message>
        <source>Measured:</source>
        <translation>Измерены:</translation>
    </message>
    <message>
        <source>Measurements missing:</source>
        <translation>Пропущено измерений:</translation>
    </message>
    <message>
        <source>Archive:</source>
        <translation>Архив:</translation>
    </message>
</context>
<context>
    <name>gorizont::UsmSettingsPanel</name>
    <message>
        <source>For all devices on the line (none of them answers)</source>
        <translation>Для всех приборов на линии (ни один не ответит)</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Адрес</translation>
    </message>
    <message>
        <source>Write the &amp;address</source>
        <translation>Зап&amp;исать адрес</translation>
    </message>
    <message>
        <source>&amp;New address:</source>
        <translation>Новый а&amp;дрес:</translation>
    </message>
    <message>
        <source>Port settings</source>
        <translation>Параметры порта</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>even</source>
        <translation>чёт</translation>
    </message>
    <message>
        <source>odd</source>
        <translation>нечёт</translation>
    </message>
    <message>
        <source>Factory settings 9600-N-1</source>
        <translation>Заводские 9600-N-1</translation>
    </message>
    <message>
        <source>Write the &amp;port settings</source>
        <translation>Записать &amp;параметры порта</translation>
    </message>
    <message>
        <source>Afterwards the device is asked at the new settings.</source>
        <translation>После этого прибор опрашивается с новыми параметрами.</translation>
    </message>
    <message>
        <source>Speed:</source>
        <translation>Скорость:</translation>
    </message>
    <message>
        <source>Parity:</source>
        <translation>Чётность:</translation>
    </message>
    <message>
        <source>Stop bits:</source>
        <translation>Стоп-биты:</translation>
    </message>
    <message>
        <source>A device hangs</source>
        <translation>Прибор завис</translation>
    </message>
    <message>
        <source>Keep silent for 30 s</source>
        <translation>Молчать 30 с</translation>
    </message>
    <message>
        <source>Every УСМ restarts that hears no message for 26 s, those that do not hang too.</source>
        <translation>Каждый УСМ, который 26 с не слышит сообщений, перезапускается, исправные тоже.</translation>
    </message>
    <message>
        <source>Addresses where nobody answered</source>
        <translation>Адреса, по которым никто не ответил</translation>
    </message>
    <message>
        <source>The address can be changed only after a complete scan that was not stopped.</source>
        <translation>Адрес можно сменить только после полного сканирования, которое не было остановлено.</translation>
    </message>
</context>
<context>
    <name>gorizont::UsmText</name>
    <message>
        <source>out of the range of measurement, %1 °C</source>
        <translation>вне диапазона измерения, %1 °C</translation>
    </message>
    <message>
        <source>the device cannot measure; its transducer may be broken (ErrorSensor)</source>
        <translation>прибор не смог измерить, возможно, неисправен датчик (ErrorSensor)</translation>
    </message>
    <message>
        <source>the device has no such channel (ErrorCH)</source>
        <translation>у прибора нет такого канала (ErrorCH)</translation>
    </message>
    <message>
        <source>the device does not understand the request (ErrorData)</source>
        <translation>прибор не понял запрос (ErrorData)</translation>
    </message>
    <message>
        <source>%1: it is there, but does not tell its address; scan the addresses</source>
        <translation>%1: есть на линии, но адреса не сообщает; просканируйте адреса</translation>
    </message>
    <message>
        <source>%1: address %2</source>
        <translation>%1: адрес %2</translation>
    </message>
    <message>
        <source>new address %1, written</source>
        <translation>новый адрес %1 записан</translation>
    </message>
    <message>
        <source>new address %1, not written: it is taken, or the device will not. Scan again.</source>
        <translation>новый адрес %1 не записан: он занят или прибор отказывается. Просканируйте ещё раз.</translation>
    </message>
    <message>
        <source>new address %1, not written: the device still answers at %2.</source>
        <translation>новый адрес %1 не записан: прибор по-прежнему отвечает по адресу %2.</translation>
    </message>
    <message>
        <source>new address %1, %2: whether it was written is not known. Scan the line to find the device.</source>
        <translation>новый адрес %1, %2: записан ли он, неизвестно. Просканируйте линию, чтобы найти прибор.</translation>
    </message>
    <message>
        <source>it answers at its new port settings %1</source>
        <translation>отвечает с новыми параметрами порта %1</translation>
    </message>
    <message>
        <source>it has taken the new port settings %1; this line cannot be switched over to try them</source>
        <translation>принял новые параметры порта %1; эту линию нельзя переключить, чтобы их проверить</translation>
    </message>
    <message>
        <source>it refuses the port settings %1; nothing was changed</source>
        <translation>отказывается от параметров порта %1; ничего не изменено</translation>
    </message>
    <message>
        <source>it still answers at the old port settings, not at %1</source>
        <translation>по-прежнему отвечает со старыми параметрами порта, не с %1</translation>
    </message>
    <message>
        <source>it answers neither at the old port settings nor at %1. Switch it off and on: for its first second it listens at 9600-N-1</source>
        <translation>не отвечает ни со старыми параметрами порта, ни с %1. Выключите и включите его: первую секунду он слушает на 9600-N-1</translation>
    </message>
    <message>
        <source>what became of the port settings %1 is not known (%2)</source>
        <translation>что стало с параметрами порта %1, неизвестно (%2)</translation>
    </message>
    <message>
        <source>Write BaudRate=%1, Parity=%2, StopBits=%3 into [Port%4] of the configuration file and start the program again: until then it does not hear the device.</source>
        <translation>Впишите BaudRate=%1, Parity=%2, StopBits=%3 в [Port%4] файла конфигурации и перезапустите программу: до этого она прибор не услышит.</translation>
    </message>
    <message>
        <source>it records and sleeps; polling gets no answer until it is woken</source>
        <translation>регистрирует и спит; пока его не разбудят, на опрос он не отвечает</translation>
    </message>
    <message>
        <source>it refuses to record; nothing was changed</source>
        <translation>отказывается от режима регистратора; ничего не изменено</translation>
    </message>
    <message>
        <source>it does not answer; it may sleep already</source>
        <translation>не отвечает; возможно, уже спит</translation>
    </message>
    <message>
        <source>whether it records is not known (%1)</source>
        <translation>перешёл ли он в режим регистратора, неизвестно (%1)</translation>
    </message>
</context>
<context>
    <name>gorizont::VibrationPage</name>
    <message>
        <source>&amp;Capture</source>
        <translation>С&amp;нять</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>Ст&amp;оп</translation>
    </message>
    <message>
        <source>&amp;every</source>
        <translation>ка&amp;ждые</translation>
    </message>
    <message>
        <source>C&amp;ursors</source>
        <translation>К&amp;урсоры</translation>
    </message>
    <message>
        <source>Captured at %1: %2 samples, %3 a second.</source>
        <translation>Снято в %1: отсчётов %2, %3 в секунду.</translation>
    </message>
    <message>
        <source>No sensor of the configuration is an L-VIMS.</source>
        <translation>В конфигурации нет ни одного L-VIMS.</translation>
    </message>
    <message>
        <source>Nothing was captured yet. Choose a channel and press &lt;Capture&gt;.</source>
        <translation>Пока ничего не снято. Выберите канал и нажмите &lt;Снять&gt;.</translation>
    </message>
    <message>
        <source>V</source>
        <translation>В</translation>
    </message>
    <message>
        <source>Stopped, because the page was left.</source>
        <translation>Остановлено: страница закрыта.</translation>
    </message>
    <message>
        <source>The waveform and both spectra of the module. Polling goes on meanwhile.</source>
        <translation>Выборка и оба спектра модуля. Опрос при этом продолжается.</translation>
    </message>
    <message>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <source>Seconds from one capture to the next</source>
        <translation>Секунд от одного снятия до следующего</translation>
    </message>
    <message>
        <source>&amp;Module:</source>
        <translation>&amp;Модуль:</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Остановлено.</translation>
    </message>
    <message>
        <source>physical units</source>
        <translation>физические единицы</translation>
    </message>
    <message>
        <source>volts</source>
        <translation>вольты</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>амплитуда</translation>
    </message>
    <message>
        <source>density</source>
        <translation>плотность</translation>
    </message>
    <message>
        <source>Two cursors in each plot: drag them, or Ctrl and Shift with the arrows</source>
        <translation>По два курсора на каждом графике: мышью или стрелками с Ctrl и Shift</translation>
    </message>
    <message>
        <source>&amp;Whole</source>
        <translation>&amp;Целиком</translation>
    </message>
    <message>
        <source>Shows all of each plot; the wheel and + − zoom, dragging and the arrows move</source>
        <translation>Каждый график целиком; колесо и + − меняют масштаб, мышь и стрелки двигают</translation>
    </message>
    <message>
        <source>&amp;In:</source>
        <translation>Е&amp;диницы:</translation>
    </message>
    <message>
        <source>S&amp;pectra:</source>
        <translation>С&amp;пектры:</translation>
    </message>
    <message>
        <source>Waveform as a table (CSV)…</source>
        <translation>Выборка таблицей (CSV)…</translation>
    </message>
    <message>
        <source>Waveform as sound (WAV)…</source>
        <translation>Выборка звуком (WAV)…</translation>
    </message>
    <message>
        <source>Spectrum up to 5000 Hz as a table (CSV)…</source>
        <translation>Спектр до 5000 Гц таблицей (CSV)…</translation>
    </message>
    <message>
        <source>Spectrum up to 200 Hz as a table (CSV)…</source>
        <translation>Спектр до 200 Гц таблицей (CSV)…</translation>
    </message>
    <message>
        <source>Nothing was captured yet.</source>
        <translation>Пока ничего не снято.</translation>
    </message>
    <message>
        <source>The file was not written (%1). Choose another folder.</source>
        <translation>Файл не записан (%1). Выберите другую папку.</translation>
    </message>
    <message>
        <source>Save what was captured</source>
        <translation>Сохранить снятое</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Сохранено: %1.</translation>
    </message>
    <message>
        <source>S&amp;ave</source>
        <translation>Сохр&amp;анить</translation>
    </message>
    <message>
        <source>Cha&amp;nnel:</source>
        <translation>&amp;Канал:</translation>
    </message>
</context>
<context>
    <name>gorizont::VibrationPlots</name>
    <message>
        <source>Waveform</source>
        <translation>Выборка</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Время, с</translation>
    </message>
    <message>
        <source>of the module, to 5000 Hz</source>
        <translation>модуль, до 5000 Гц</translation>
    </message>
    <message>
        <source>Spectrum up to 5000 Hz</source>
        <translation>Спектр до 5000 Гц</translation>
    </message>
    <message>
        <source>of the module, to 200 Hz</source>
        <translation>модуль, до 200 Гц</translation>
    </message>
    <message>
        <source>Spectrum up to 200 Hz</source>
        <translation>Спектр до 200 Гц</translation>
    </message>
    <message>
        <source>Voltage, %1</source>
        <translation>Напряжение, %1</translation>
    </message>
    <message>
        <source>Acceleration, %1</source>
        <translation>Ускорение, %1</translation>
    </message>
    <message>
        <source>Peaks of the waveform, %1</source>
        <translation>Пики по выборке, %1</translation>
    </message>
    <message>
        <source>Waveform: A %1 s: %2; B %3 s: %4; B − A %5 s (1/T = %6 Hz): %7 %8</source>
        <translation>Выборка: A %1 с: %2; B %3 с: %4; B − A %5 с (1/T = %6 Гц): %7 %8</translation>
    </message>
    <message>
        <source>%1 (module | waveform): A %2 Hz: %3; B %4 Hz: %5; B − A %6 Hz</source>
        <translation>%1 (модуль | выборка): A %2 Гц: %3; B %4 Гц: %5; B − A %6 Гц</translation>
    </message>
</context>
<context>
    <name>gorizont::VimsComparison</name>
    <message>
        <source>Settings that differ</source>
        <translation>Настройки, которые различаются</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Настройка</translation>
    </message>
    <message>
        <source>In use (CUR)</source>
        <translation>Действует (CUR)</translation>
    </message>
    <message>
        <source>Prepared (MUT)</source>
        <translation>Подготовлено (MUT)</translation>
    </message>
    <message>
        <source>In this window</source>
        <translation>В этом окне</translation>
    </message>
</context>
<context>
    <name>gorizont::VimsDialog</name>
    <message>
        <source>&amp;Discard</source>
        <translation>Н&amp;е применять</translation>
    </message>
    <message>
        <source>What was changed here is not written to the module yet. Discard it?</source>
        <translation>Изменённое здесь ещё не записано в модуль. Отбросить?</translation>
    </message>
    <message>
        <source>Reading the module…</source>
        <translation>Чтение модуля…</translation>
    </message>
    <message>
        <source>The module cannot be read: %1. Check its power and its network cable.</source>
        <translation>Модуль не читается: %1. Проверьте питание и сетевой кабель.</translation>
    </message>
    <message>
        <source>The settings cannot be read: %1. Read them again.</source>
        <translation>Настройки не читаются: %1. Прочитайте их снова.</translation>
    </message>
    <message>
        <source>Prepare these settings in the module (MUT)? It does not use them before &lt;Apply&gt;, nor after a restart.</source>
        <translation>Подготовить эти настройки в модуле (MUT)? До нажатия &lt;Применить&gt; он ими не пользуется, после перезапуска тоже.</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>За&amp;пись</translation>
    </message>
    <message>
        <source>settings prepared</source>
        <translation>настройки подготовлены</translation>
    </message>
    <message>
        <source>Writing the settings…</source>
        <translation>Запись настроек…</translation>
    </message>
    <message>
        <source>settings prepared in the module; it does not use them yet</source>
        <translation>настройки подготовлены в модуле; он ими ещё не пользуется</translation>
    </message>
    <message>
        <source>the settings were not written whole: %1%2</source>
        <translation>настройки записаны не полностью: %1%2</translation>
    </message>
    <message>
        <source>Let the module use the prepared settings from now on? Measurements and relays follow them at once.</source>
        <translation>Модулю пользоваться подготовленными настройками? Измерения и реле перейдут на них сразу.</translation>
    </message>
    <message>
        <source>They do not differ from those in use.</source>
        <translation>Они не отличаются от действующих.</translation>
    </message>
    <message>
        <source>What was changed here and not written is not among them.</source>
        <translation>Изменённого здесь и не записанного среди них нет.</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>&amp;Применить</translation>
    </message>
    <message>
        <source>settings applied</source>
        <translation>настройки применены</translation>
    </message>
    <message>
        <source>Keep the prepared settings in the flash of the module? It starts with them from now on; those that were there before are lost.</source>
        <translation>Сохранить подготовленные настройки во flash модуля? Дальше он будет запускаться с ними; прежние пропадут.</translation>
    </message>
    <message>
        <source>After its next start the module has another network address: %1.</source>
        <translation>После следующего запуска у модуля будет другой сетевой адрес: %1.</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Сохранить</translation>
    </message>
    <message>
        <source>settings kept in flash</source>
        <translation>настройки сохранены во flash</translation>
    </message>
    <message>
        <source>Let the module use the settings of its flash again? What was prepared or applied and not kept is lost. If its network address is another one there, the connection will be lost.</source>
        <translation>Вернуть модуль к настройкам из flash? Подготовленное и применённое, но не сохранённое пропадёт. Если там другой сетевой адрес, связь прервётся.</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>&amp;Вернуть</translation>
    </message>
    <message>
        <source>settings reloaded from flash</source>
        <translation>настройки взяты из flash</translation>
    </message>
    <message>
        <source>Restart the module? It measures nothing meanwhile, its relays may change, and settings that were not kept in flash are lost.</source>
        <translation>Перезапустить модуль? В это время он не измеряет, реле могут переключиться, а настройки, не сохранённые во flash, пропадут.</translation>
    </message>
    <message>
        <source>&amp;Restart</source>
        <translation>&amp;Перезапустить</translation>
    </message>
    <message>
        <source>Writing: %1…</source>
        <translation>Запись: %1…</translation>
    </message>
    <message>
        <source>%1; the module has its new network address</source>
        <translation>%1; у модуля новый сетевой адрес</translation>
    </message>
    <message>
        <source>%1, not done: %2%3</source>
        <translation>%1 — не выполнено: %2%3</translation>
    </message>
    <message>
        <source>restart</source>
        <translation>перезапуск</translation>
    </message>
    <message>
        <source>the module restarts</source>
        <translation>модуль перезапускается</translation>
    </message>
    <message>
        <source>%1, not done: %2</source>
        <translation>%1 — не выполнено: %2</translation>
    </message>
    <message>
        <source>The module restarts. Service has ended; it is polled again as soon as it answers.</source>
        <translation>Модуль перезапускается. Обслуживание окончено; опрос продолжится, как только он ответит.</translation>
    </message>
    <message>
        <source>Open settings</source>
        <translation>Открыть настройки</translation>
    </message>
    <message>
        <source>%1 is no file of settings. Choose one that this window or gorizont-tool vims has saved.</source>
        <translation>%1 — не файл настроек. Выберите файл, сохранённый этим окном или gorizont-tool vims.</translation>
    </message>
    <message>
        <source>The form shows the settings of %1. &lt;Write&gt; prepares them in the module.</source>
        <translation>В окне настройки из %1. &lt;Записать&gt; подготовит их в модуле.</translation>
    </message>
    <message>
        <source>Save the settings</source>
        <translation>Сохранить настройки</translation>
    </message>
    <message>
        <source>The settings in use are in %1.</source>
        <translation>Действующие настройки — в %1.</translation>
    </message>
    <message>
        <source>The settings were not saved (%1). Choose another folder.</source>
        <translation>Настройки не сохранены (%1). Выберите другую папку.</translation>
    </message>
</context>
<context>
    <name>gorizont::VimsField</name>
    <message>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <source>%1: in use is %2</source>
        <translation>%1: действует %2</translation>
    </message>
</context>
<context>
    <name>gorizont::VimsForm</name>
    <message>
        <source>&amp;Module:</source>
        <translation>&amp;Модуль:</translation>
    </message>
    <message>
        <source>Module</source>
        <translation>Модуль</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Настройки</translation>
    </message>
    <message>
        <source>Rea&amp;d</source>
        <translation>П&amp;рочитать</translation>
    </message>
    <message>
        <source>Reads all settings again, those in use and those prepared.</source>
        <translation>Читает все настройки заново, действующие и подготовленные.</translation>
    </message>
    <message>
        <source>&amp;Write…</source>
        <translation>Запис&amp;ать…</translation>
    </message>
    <message>
        <source>Prepares what was changed here (MUT). The module does not use it yet.</source>
        <translation>Подготавливает изменённое здесь (MUT). Модуль этим ещё не пользуется.</translation>
    </message>
    <message>
        <source>&amp;Apply…</source>
        <translation>&amp;Применить…</translation>
    </message>
    <message>
        <source>The module uses the prepared settings until its next start.</source>
        <translation>Модуль пользуется подготовленными настройками до следующего запуска.</translation>
    </message>
    <message>
        <source>&amp;Keep in flash…</source>
        <translation>&amp;Сохранить во flash…</translation>
    </message>
    <message>
        <source>The module starts with the prepared settings from now on.</source>
        <translation>Дальше модуль запускается с подготовленными настройками.</translation>
    </message>
    <message>
        <source>&amp;From a file…</source>
        <translation>&amp;Из файла…</translation>
    </message>
    <message>
        <source>Fills the form from a backup. Nothing is written yet.</source>
        <translation>Заполняет окно из копии. Ничего ещё не пишется.</translation>
    </message>
    <message>
        <source>Keeps the settings in use as a backup.</source>
        <translation>Сохраняет действующие настройки как копию.</translation>
    </message>
    <message>
        <source>The module uses the settings of its flash again; what was only applied is lost.</source>
        <translation>Модуль снова пользуется настройками из flash; только применённое пропадает.</translation>
    </message>
    <message>
        <source>Differences (%1)</source>
        <translation>Различия (%1)</translation>
    </message>
    <message>
        <source>&amp;To a file…</source>
        <translation>В &amp;файл…</translation>
    </message>
    <message>
        <source>Reload from flas&amp;h…</source>
        <translation>Верн&amp;уть из flash…</translation>
    </message>
</context>
<context>
    <name>gorizont::VimsModulePanel</name>
    <message>
        <source>&amp;Restart the module…</source>
        <translation>Пер&amp;езапустить модуль…</translation>
    </message>
    <message>
        <source>About the module</source>
        <translation>О модуле</translation>
    </message>
    <message>
        <source>Name of the device:</source>
        <translation>Название устройства:</translation>
    </message>
    <message>
        <source>Serial number:</source>
        <translation>Серийный номер:</translation>
    </message>
    <message>
        <source>Program:</source>
        <translation>Прошивка:</translation>
    </message>
    <message>
        <source>Revision of the board:</source>
        <translation>Ревизия платы:</translation>
    </message>
    <message>
        <source>Mode:</source>
        <translation>Режим:</translation>
    </message>
    <message>
        <source>Error of the last write (LAST_WR_ERROR):</source>
        <translation>Ошибка последней записи (LAST_WR_ERROR):</translation>
    </message>
    <message>
        <source>Error of the settings (LAST_CHECK_SETTINGS_ERR):</source>
        <translation>Ошибка настроек (LAST_CHECK_SETTINGS_ERR):</translation>
    </message>
</context>
<context>
    <name>gorizont::VimsSettingsPanel</name>
    <message>
        <source>Module</source>
        <translation>Модуль</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Имя:</translation>
    </message>
    <message>
        <source>IP address:</source>
        <translation>Адрес IP:</translation>
    </message>
    <message>
        <source>Mask:</source>
        <translation>Маска:</translation>
    </message>
    <message>
        <source>Gateway:</source>
        <translation>Шлюз:</translation>
    </message>
    <message>
        <source>Length of a waveform:</source>
        <translation>Длина выборки:</translation>
    </message>
    <message>
        <source>Channels that measure:</source>
        <translation>Каналы с измерениями:</translation>
    </message>
    <message>
        <source>Sensors that are fed:</source>
        <translation>Питание датчиков:</translation>
    </message>
    <message>
        <source>Channel %1</source>
        <translation>Канал %1</translation>
    </message>
    <message>
        <source>Sensor: K, mV/g:</source>
        <translation>Датчик: K, мВ/g:</translation>
    </message>
    <message>
        <source>B, mV/g:</source>
        <translation>B, мВ/g:</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Измерение</translation>
    </message>
    <message>
        <source>High-pass, Hz</source>
        <translation>ФВЧ, Гц</translation>
    </message>
    <message>
        <source>Low-pass, Hz</source>
        <translation>ФНЧ, Гц</translation>
    </message>
</context>
<context>
    <name>gorizont::VimsText</name>
    <message>
        <source>%1, boot loader: it measures nothing</source>
        <translation>%1, загрузчик: измерений нет</translation>
    </message>
    <message>
        <source>%1, at work</source>
        <translation>%1, рабочий</translation>
    </message>
    <message>
        <source>0, none</source>
        <translation>0, нет</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>и ещё %n</numerusform>
            <numerusform>и ещё %n</numerusform>
            <numerusform>и ещё %n</numerusform>
        </translation>
    </message>
    <message>
        <source>The network settings change: the connection to the module will be lost. Write the new address %1 into Device of [Port%2] in the configuration file and start the program again.</source>
        <translation>Меняются сетевые настройки: связь с модулем прервётся. Запишите новый адрес %1 в Device секции [Port%2] файла конфигурации и запустите программу снова.</translation>
    </message>
</context>
<context>
    <name>gorizont::WaveformPage</name>
    <message>
        <source>No sensor of the configuration measures accelerations.</source>
        <translation>Ни один датчик конфигурации не измеряет ускорения.</translation>
    </message>
    <message>
        <source>There are no samples in this span. Choose a longer span or another sensor.</source>
        <translation>За это время отсчётов нет. Выберите больший промежуток или другой датчик.</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Отсчёты</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Спектр</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Частота, Гц</translation>
    </message>
    <message>
        <source>Amplitude, %1</source>
        <translation>Амплитуда, %1</translation>
    </message>
    <message>
        <source>Window of the spectrum</source>
        <translation>Окно спектра</translation>
    </message>
    <message>
        <source>Hann</source>
        <translation>Ханн</translation>
    </message>
    <message>
        <source>Hamming</source>
        <translation>Хэмминг</translation>
    </message>
    <message>
        <source>Blackman-Harris</source>
        <translation>Блэкман—Харрис</translation>
    </message>
    <message>
        <source>no window</source>
        <translation>без окна</translation>
    </message>
    <message>
        <source>Samples of a segment: more give finer lines, fewer are averaged oftener and calm the noise</source>
        <translation>Отсчётов в отрезке: больше — тоньше линии, меньше — больше усреднений и спокойнее шум</translation>
    </message>
    <message>
        <source>%1 samples</source>
        <translation>%1 отсчётов</translation>
    </message>
    <message>
        <source>%1 Hz (%2)</source>
        <translation>%1 Гц (%2)</translation>
    </message>
    <message>
        <source>Too few samples for a spectrum.</source>
        <translation>Для спектра мало отсчётов.</translation>
    </message>
    <message>
        <source>Segments averaged: %1, a line every %2 Hz. %3</source>
        <translation>Усреднено отрезков: %1, линия через %2 Гц. %3</translation>
    </message>
    <message>
        <source>No frequency stands out.</source>
        <translation>Ни одна частота не выделяется.</translation>
    </message>
</context>
<context>
    <name>gorizont::WeatherModel</name>
    <message>
        <source>What the station measures</source>
        <translation>Что измеряет станция</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Параметр</translation>
    </message>
    <message>
        <source>Code and number of the parameter in the station</source>
        <translation>Код и номер параметра на станции</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Код</translation>
    </message>
    <message>
        <source>Unit of all columns but the last two</source>
        <translation>Единица всех столбцов, кроме двух последних</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Единица</translation>
    </message>
    <message>
        <source>Mean over the averaging interval of the station</source>
        <translation>Среднее за интервал осреднения станции</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Среднее</translation>
    </message>
    <message>
        <source>Value of the last seconds</source>
        <translation>Значение последних секунд</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Сейчас</translation>
    </message>
    <message>
        <source>Least value of the averaging interval</source>
        <translation>Наименьшее значение за интервал осреднения</translation>
    </message>
    <message>
        <source>Min.</source>
        <translation>Мин.</translation>
    </message>
    <message>
        <source>Largest value of the averaging interval</source>
        <translation>Наибольшее значение за интервал осреднения</translation>
    </message>
    <message>
        <source>Max.</source>
        <translation>Макс.</translation>
    </message>
    <message>
        <source>Largest value since the station was asked before</source>
        <translation>Наибольшее значение с предыдущего запроса станции</translation>
    </message>
    <message>
        <source>Max. since request</source>
        <translation>Макс. за срок</translation>
    </message>
    <message>
        <source>Root mean square deviation</source>
        <translation>Среднеквадратическое отклонение</translation>
    </message>
    <message>
        <source>σ</source>
        <translation>σ</translation>
    </message>
    <message>
        <source>Measured before any conversion, mean, V or Hz</source>
        <translation>Измерено до преобразования, среднее, В или Гц</translation>
    </message>
    <message>
        <source>Voltage, V</source>
        <translation>Напряжение, В</translation>
    </message>
    <message>
        <source>Measured before any conversion, last seconds, V or Hz</source>
        <translation>Измерено до преобразования, последние секунды, В или Гц</translation>
    </message>
    <message>
        <source>Voltage now, V</source>
        <translation>Мгнов. напр., В</translation>
    </message>
</context>
<context>
    <name>gorizont::WeatherPage</name>
    <message>
        <source>The configuration names no weather station (МК-14).</source>
        <translation>В конфигурации нет ни одной метеостанции (МК-14).</translation>
    </message>
    <message>
        <source>The station answers, but it has no data yet.</source>
        <translation>Станция отвечает, но у неё ещё нет данных.</translation>
    </message>
    <message>
        <source>The station answers, but none of its values is valid.</source>
        <translation>Станция отвечает, но ни одно из её значений не достоверно.</translation>
    </message>
    <message>
        <source>The station has no data. It sends them as soon as it has measured.</source>
        <translation>У станции нет данных. Она передаст их, как только измерит.</translation>
    </message>
    <message>
        <source>The station has not answered yet. Its parameters are listed after the first answer.</source>
        <translation>Станция ещё не отвечала. Её параметры появятся после первого ответа.</translation>
    </message>
    <message>
        <source>Age of the data: %1</source>
        <translation>Возраст данных: %1</translation>
    </message>
    <message>
        <source>Weather station</source>
        <translation>Метеостанция</translation>
    </message>
    <message>
        <source>Time over which the winds are gathered</source>
        <translation>Время, за которое собран ветер</translation>
    </message>
    <message>
        <source>10 minutes</source>
        <translation>10 минут</translation>
    </message>
    <message>
        <source>1 hour</source>
        <translation>1 час</translation>
    </message>
    <message>
        <source>6 hours</source>
        <translation>6 часов</translation>
    </message>
    <message>
        <source>24 hours</source>
        <translation>24 часа</translation>
    </message>
    <message>
        <source>&amp;Rose over:</source>
        <translation>&amp;Роза за:</translation>
    </message>
    <message>
        <source>The wind as numbers</source>
        <translation>Ветер числами</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Цифровые входы</translation>
    </message>
    <message>
        <source>Precipitation</source>
        <translation>Осадки</translation>
    </message>
    <message>
        <source>Parameters of the weather station</source>
        <translation>Параметры метеостанции</translation>
    </message>
    <message>
        <source>%1: its values are not to be trusted. Check the power supply.</source>
        <translation>%1: её значениям верить нельзя. Проверьте питание.</translation>
    </message>
    <message>
        <source>No precipitation is known. Only command 8 brings it.</source>
        <translation>Осадков нет. О них сообщает только команда 8.</translation>
    </message>
    <message>
        <source>Errors in the files of the station</source>
        <translation>Ошибки в файлах станции</translation>
    </message>
</context>
<context>
    <name>gorizont::WindRoseView</name>
    <message>
        <source>▲ now %1, %2 m/s</source>
        <translation>▲ сейчас %1, %2 м/с</translation>
    </message>
    <message>
        <source>△ mean %1, %2 m/s; gust %3 m/s</source>
        <translation>△ среднее %1, %2 м/с; порыв %3 м/с</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>штиль</translation>
    </message>
    <message>
        <source>Wind rose</source>
        <translation>Роза ветров</translation>
    </message>
    <message>
        <source>from %1 m/s</source>
        <translation>от %1 м/с</translation>
    </message>
    <message>
        <source>%1 – %2 m/s</source>
        <translation>%1 – %2 м/с</translation>
    </message>
    <message>
        <source>Wind now: %1, %2 m/s.</source>
        <translation>Ветер сейчас: %1, %2 м/с.</translation>
    </message>
    <message>
        <source>The wind is not known now.</source>
        <translation>Ветер сейчас неизвестен.</translation>
    </message>
    <message>
        <source>No reading of the wind has come yet.</source>
        <translation>Показаний ветра ещё не было.</translation>
    </message>
    <message>
        <source>calm %1 %</source>
        <translation>штиль %1 %</translation>
    </message>
    <message>
        <source>Shares over %1: %2.</source>
        <translation>Доли за %1: %2.</translation>
    </message>
</context>
<context>
    <name>gorizont::XyPage</name>
    <message>
        <source>start</source>
        <translation>начало</translation>
    </message>
    <message>
        <source>end</source>
        <translation>конец</translation>
    </message>
    <message>
        <source>In what angles are drawn</source>
        <translation>В чём показаны углы</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>градусы</translation>
    </message>
    <message>
        <source>arc-seconds</source>
        <translation>угл. секунды</translation>
    </message>
    <message>
        <source>No sensor of the configuration measures tilt.</source>
        <translation>Ни один датчик конфигурации не измеряет наклон.</translation>
    </message>
    <message>
        <source>There are no angles in this span. Choose a longer span or another sensor.</source>
        <translation>За это время наклонов нет. Выберите больший промежуток или другой датчик.</translation>
    </message>
    <message>
        <source>Way of the axis</source>
        <translation>Путь оси</translation>
    </message>
</context>
<context>
    <name>gorizont::station::Doors</name>
    <message>
        <source>%1 is no place to listen: tcp://ADDRESS:PORT with an address in digits is.</source>
        <translation>%1 — не место, где можно ждать: нужно tcp://АДРЕС:ПОРТ с адресом из цифр.</translation>
    </message>
</context>
<context>
    <name>gorizont::station::Gatherer</name>
    <message>
        <source>no line leads there</source>
        <translation>туда не ведёт ни одна линия</translation>
    </message>
</context>
<context>
    <name>gorizont::station::Gathering</name>
    <message>
        <source>Station %1 answers.</source>
        <translation>Станция %1 отвечает.</translation>
    </message>
    <message>
        <source>Station %1 does not answer (%2); its parameters have no value.</source>
        <translation>Станция %1 не отвечает (%2); у её параметров нет значения.</translation>
    </message>
</context>
<context>
    <name>gorizont::station::SerialDoor</name>
    <message>
        <source>%1: open for dispatchers</source>
        <translation>%1: открыт для диспетчеров</translation>
    </message>
    <message>
        <source>there is no such device</source>
        <translation>такого устройства нет</translation>
    </message>
    <message>
        <source>%1 is closed for dispatchers (%2) and is tried again and again</source>
        <translation>%1: закрыт для диспетчеров (%2), попытки повторяются</translation>
    </message>
</context>
<context>
    <name>gorizont::station::Station</name>
    <message>
        <source>Station %1 started</source>
        <translation>Станция %1 запущена</translation>
    </message>
    <message>
        <source>Station %1 ended</source>
        <translation>Станция %1 остановлена</translation>
    </message>
    <message>
        <source>The files of the station are read again.</source>
        <translation>Файлы станции читаются снова.</translation>
    </message>
    <message>
        <source>The clock of the computer was set by %1 s.</source>
        <translation>Часы компьютера переставлены на %1 с.</translation>
    </message>
    <message>
        <source>A dispatcher has set the clock to %1, by %2 s.</source>
        <translation>Диспетчер поставил часы на %1, на %2 с.</translation>
    </message>
    <message>
        <source>The file %1 of a dispatcher was refused: %2</source>
        <translation>Файл %1 от диспетчера отклонён: %2</translation>
    </message>
    <message>
        <source>A dispatcher has sent the file %1; the one before is kept as .bak.</source>
        <translation>Диспетчер прислал файл %1; прежний оставлен с окончанием .bak.</translation>
    </message>
</context>
<context>
    <name>gorizont::station::StationStorage</name>
    <message>
        <source>The clock that was set is lost at the next start: %1</source>
        <translation>При следующем запуске часы не сохранятся: %1</translation>
    </message>
    <message>
        <source>Records are saved again.</source>
        <translation>Записи снова сохраняются.</translation>
    </message>
    <message>
        <source>The unfinished last record of %1 was removed.</source>
        <translation>Незаконченная последняя запись в %1 удалена.</translation>
    </message>
    <message>
        <source>Records cannot be saved (%1). The newest %2 wait.</source>
        <translation>Записи не сохраняются (%1). Последние %2 ждут.</translation>
    </message>
</context>
<context>
    <name>gorizont::station::TcpDoor</name>
    <message>
        <source>TCP %1:%2: open for dispatchers</source>
        <translation>TCP %1:%2: открыт для диспетчеров</translation>
    </message>
    <message>
        <source>TCP %1 is closed for dispatchers (%2) and is tried again and again</source>
        <translation>TCP %1: закрыт для диспетчеров (%2), попытки повторяются</translation>
    </message>
</context>
<context>
    <name>gorizont::tool::HistoryImport</name>
    <message>
        <source>No file in %1 is of this configuration. Name the one they were made with by --config.</source>
        <translation>Ни один файл в %1 не относится к этой конфигурации. Укажите ту, с которой они записаны, ключом --config.</translation>
    </message>
    <message>
        <source>There are no old records in %1. Name the folder with files like 2018_02_data.txt.</source>
        <translation>В %1 нет старых записей. Укажите папку с файлами вида 2018_02_data.txt.</translation>
    </message>
    <message>
        <source>%1 holds no records and is left out.</source>
        <translation>В %1 нет записей, файл пропущен.</translation>
    </message>
    <message>
        <source>%1 holds %2 sensors and the configuration has %3: it is left out, because nobody knows whose the values are.</source>
        <translation>В %1 датчиков: %2, а в конфигурации: %3. Файл пропущен, так как неизвестно, чьи это показания.</translation>
    </message>
    <message>
        <source>%1: damaged lines, %2 in all, are left out: %3.</source>
        <translation>%1: пропущены повреждённые строки, всего %2: %3.</translation>
    </message>
</context>
<context>
    <name>gorizont::tool::Text</name>
    <message>
        <source>address %1 is taken; nothing was changed</source>
        <translation>адрес %1 занят; ничего не изменено</translation>
    </message>
    <message>
        <source>nothing was changed (%1)</source>
        <translation>ничего не изменено (%1)</translation>
    </message>
    <message>
        <source>the configuration of the sensor is not as expected; nothing was stored</source>
        <translation>конфигурация датчика не такая, как ожидалось; ничего не записано</translation>
    </message>
    <message>
        <source>nothing was stored (%1)</source>
        <translation>ничего не записано (%1)</translation>
    </message>
    <message>
        <source>whether the new address was stored is not known (%1); the old one holds until a restart</source>
        <translation>неизвестно, записан ли новый адрес (%1); до сброса действует прежний</translation>
    </message>
    <message>
        <source>the sensor restarts, about %1 s…</source>
        <translation>датчик перезапускается, около %1 с…</translation>
    </message>
    <message>
        <source>Store the address %2 in the sensor with address %1?</source>
        <translation>Записать в датчик с адресом %1 новый адрес %2?</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>ничего не записано</translation>
    </message>
    <message>
        <source>The address is stored. Restart the sensor, so that it holds?</source>
        <translation>Адрес записан. Сбросить датчик, чтобы он подействовал?</translation>
    </message>
    <message>
        <source>the new address is stored and holds after the next restart</source>
        <translation>новый адрес записан и подействует после следующего сброса</translation>
    </message>
    <message>
        <source>the new address is stored, but the sensor does not answer there (%1); scan the line</source>
        <translation>новый адрес записан, но датчик по нему не отвечает (%1); выполните поиск на линии</translation>
    </message>
    <message>
        <source>The sensor now answers at address %1.</source>
        <translation>Датчик теперь отвечает по адресу %1.</translation>
    </message>
    <message>
        <source>Restart the sensor with address %1?</source>
        <translation>Сбросить датчик с адресом %1?</translation>
    </message>
    <message>
        <source>nothing was done</source>
        <translation>ничего не сделано</translation>
    </message>
    <message>
        <source>the sensor does not answer (%1)</source>
        <translation>датчик не отвечает (%1)</translation>
    </message>
    <message>
        <source>The sensor has restarted and answers.</source>
        <translation>Датчик перезапустился и отвечает.</translation>
    </message>
    <message>
        <source>Address: %1</source>
        <translation>Адрес: %1</translation>
    </message>
    <message>
        <source>Firmware: %1, build %2</source>
        <translation>Прошивка: %1, сборка %2</translation>
    </message>
    <message>
        <source>Tilt X: %1″</source>
        <translation>Угол X: %1″</translation>
    </message>
    <message>
        <source>Tilt Y: %1″</source>
        <translation>Угол Y: %1″</translation>
    </message>
    <message>
        <source>Temperature: %1 °C</source>
        <translation>Температура: %1 °C</translation>
    </message>
    <message>
        <source>Fan: %1 1/s</source>
        <translation>Вентилятор: %1 1/с</translation>
    </message>
    <message>
        <source>Heater: %1 %</source>
        <translation>Нагрев: %1 %</translation>
    </message>
    <message>
        <source>Measurements since the start: %1</source>
        <translation>Измерений с запуска: %1</translation>
    </message>
    <message>
        <source>Configuration: %1</source>
        <translation>Конфигурация: %1</translation>
    </message>
    <message>
        <source>firmware %1, build %2</source>
        <translation>прошивка %1, сборка %2</translation>
    </message>
    <message>
        <source>looks for sensors at the addresses 1…255</source>
        <translation>ищет датчики по адресам 1…255</translation>
    </message>
    <message>
        <source>prints what the sensor measures</source>
        <translation>печатает измерения датчика</translation>
    </message>
    <message>
        <source>prints what the sensor is and its settings</source>
        <translation>печатает сведения о датчике и его настройки</translation>
    </message>
    <message>
        <source>gives the sensor another address; an АН-Д3 is restarted</source>
        <translation>меняет адрес датчика; АН-Д3 при этом сбрасывается</translation>
    </message>
    <message>
        <source>writes the name, at most 16 characters; not in Modbus</source>
        <translation>записывает имя, не больше 16 символов; не в Modbus</translation>
    </message>
    <message>
        <source>writes the zero offset, arc-seconds</source>
        <translation>записывает смещение нуля, угловые секунды</translation>
    </message>
    <message>
        <source>writes the averaging: --ticks, --period or both</source>
        <translation>записывает усреднение: --ticks, --period или оба</translation>
    </message>
    <message>
        <source>restarts the controller of an АН-Д3, about 5 s</source>
        <translation>сбрасывает контроллер АН-Д3, около 5 с</translation>
    </message>
    <message>
        <source>name</source>
        <translation>имя</translation>
    </message>
    <message>
        <source>zero offset</source>
        <translation>смещение нуля</translation>
    </message>
    <message>
        <source>averaging ticks</source>
        <translation>такты усреднения</translation>
    </message>
    <message>
        <source>averaging period</source>
        <translation>период усреднения</translation>
    </message>
    <message>
        <source>%1: written and read back</source>
        <translation>%1: значение записано и проверено чтением</translation>
    </message>
    <message>
        <source>%1: the sensor has not taken the new value</source>
        <translation>%1: датчик не принял новое значение</translation>
    </message>
    <message>
        <source>%1: not written (%2)</source>
        <translation>%1: не записано (%2)</translation>
    </message>
    <message>
        <source>address %1 is taken, or the sensor refuses it; nothing was changed</source>
        <translation>адрес %1 занят, или датчик его не принимает; ничего не изменено</translation>
    </message>
    <message>
        <source>the sensor still answers at address %1</source>
        <translation>датчик по-прежнему отвечает по адресу %1</translation>
    </message>
    <message>
        <source>no answer, neither at address %1 nor at %2; scan the line</source>
        <translation>нет ответа ни по адресу %1, ни по адресу %2; выполните поиск на линии</translation>
    </message>
    <message>
        <source>what became of the address is not known (%1); scan the line</source>
        <translation>неизвестно, сменился ли адрес (%1); выполните поиск на линии</translation>
    </message>
    <message>
        <source>Give the sensor with address %1 the address %2?</source>
        <translation>Записать в датчик с адресом %1 новый адрес %2?</translation>
    </message>
    <message>
        <source>Write the name &quot;%1&quot; to the sensor with address %2?</source>
        <translation>Записать имя «%1» в датчик с адресом %2?</translation>
    </message>
    <message>
        <source>Write the zero offset X %1″, Y %2″ to the sensor with address %3?</source>
        <translation>Записать смещение нуля X %1″, Y %2″ в датчик с адресом %3?</translation>
    </message>
    <message>
        <source>ticks: %1</source>
        <translation>тактов: %1</translation>
    </message>
    <message>
        <source>period: %1 ms</source>
        <translation>период: %1 мс</translation>
    </message>
    <message>
        <source>Write the averaging (%1) to the sensor with address %2?</source>
        <translation>Записать усреднение (%1) в датчик с адресом %2?</translation>
    </message>
    <message>
        <source>wrong check sum of the program</source>
        <translation>неверная контрольная сумма программы</translation>
    </message>
    <message>
        <source>wrong check sum of the settings</source>
        <translation>неверная контрольная сумма настроек</translation>
    </message>
    <message>
        <source>wrong check sums of program and settings</source>
        <translation>неверные контрольные суммы программы и настроек</translation>
    </message>
    <message>
        <source>Name: %1</source>
        <translation>Имя: %1</translation>
    </message>
    <message>
        <source>Speed: %1</source>
        <translation>Скорость обмена: %1</translation>
    </message>
    <message>
        <source>Version: %1</source>
        <translation>Версия измерителя: %1</translation>
    </message>
    <message>
        <source>Software revision: %1 (type %2, revision %3)</source>
        <translation>Номер редакции ПО: %1 (тип %2, редакция %3)</translation>
    </message>
    <message>
        <source>Serial number: %1</source>
        <translation>Заводской номер: %1</translation>
    </message>
    <message>
        <source>Zero offset X: %1″</source>
        <translation>Смещение нуля X: %1″</translation>
    </message>
    <message>
        <source>Zero offset Y: %1″</source>
        <translation>Смещение нуля Y: %1″</translation>
    </message>
    <message>
        <source>Averaging ticks: %1</source>
        <translation>Тактов усреднения: %1</translation>
    </message>
    <message>
        <source>Averaging period: %1 ms</source>
        <translation>Период усреднения: %1 мс</translation>
    </message>
    <message>
        <source>Self-test: %1</source>
        <translation>Самопроверка: %1</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>№ %1</translation>
    </message>
    <message>
        <source>there is no terminal to ask at; nothing was written. --yes writes without asking</source>
        <translation>спросить не у кого: ввод не с терминала; ничего не записано. С --yes запись идёт без вопроса</translation>
    </message>
    <message>
        <source>--%1 takes %2, not &quot;%3&quot;</source>
        <translation>--%1: нужно %2, а не «%3»</translation>
    </message>
    <message>
        <source>a command is missing; --help lists them</source>
        <translation>не указана команда; список — в --help</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;; --help lists them</source>
        <translation>нет команды «%1»; список — в --help</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>ничего</translation>
    </message>
    <message>
        <source>after %1 comes %2</source>
        <translation>после %1 должно стоять: %2</translation>
    </message>
    <message>
        <source>%1 does not take --%2</source>
        <translation>у команды %1 нет параметра --%2</translation>
    </message>
    <message>
        <source>--device is missing</source>
        <translation>не указан --device</translation>
    </message>
    <message>
        <source>--type is missing</source>
        <translation>не указан --type</translation>
    </message>
    <message>
        <source>%1 does not have the command %2</source>
        <translation>у %1 нет команды %2</translation>
    </message>
    <message>
        <source>only ind3 has a --protocol</source>
        <translation>--protocol есть только у ind3</translation>
    </message>
    <message>
        <source>--address is missing</source>
        <translation>не указан --address</translation>
    </message>
    <message>
        <source>protocol 2.10 has no settings: only scan and read</source>
        <translation>в протоколе 2.10 нет настроек: только scan и read</translation>
    </message>
    <message>
        <source>--from is after --to</source>
        <translation>--from больше --to</translation>
    </message>
    <message>
        <source>--ticks or --period is missing</source>
        <translation>не указан ни --ticks, ни --period</translation>
    </message>
    <message>
        <source>an address is 1…255, not &quot;%1&quot;</source>
        <translation>адрес — число 1…255, а не «%1»</translation>
    </message>
    <message>
        <source>there is no name in Modbus</source>
        <translation>в Modbus имени нет</translation>
    </message>
    <message>
        <source>a name has 1…16 characters of Windows-1251: &quot;%1&quot; does not</source>
        <translation>имя — 1…16 символов Windows-1251, «%1» не подходит</translation>
    </message>
    <message>
        <source>an offset is two numbers of arc-seconds, not &quot;%1&quot;</source>
        <translation>смещение — два числа в угловых секундах, а не «%1»</translation>
    </message>
    <message>
        <source>%1  somebody answers, but not clearly (%2); two sensors with one address?</source>
        <translation>%1  кто-то отвечает, но неразборчиво (%2); два датчика с одним адресом?</translation>
    </message>
    <message numerus="yes">
        <source>address %1, %n sensor(s) found</source>
        <translation>
            <numerusform>адрес %1, найден %n датчик</numerusform>
            <numerusform>адрес %1, найдено %n датчика</numerusform>
            <numerusform>адрес %1, найдено %n датчиков</numerusform>
        </translation>
    </message>
    <message>
        <source>its settings cannot be read</source>
        <translation>настройки не читаются</translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s) found</source>
        <translation>
            <numerusform>найден %n датчик</numerusform>
            <numerusform>найдено %n датчика</numerusform>
            <numerusform>найдено %n датчиков</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n address(es) asked</source>
        <translation>
            <numerusform>опрошен %n адрес</numerusform>
            <numerusform>опрошено %n адреса</numerusform>
            <numerusform>опрошено %n адресов</numerusform>
        </translation>
    </message>
    <message>
        <source>no answer from address %1</source>
        <translation>нет ответа с адреса %1</translation>
    </message>
    <message>
        <source>only damaged answers from address %1</source>
        <translation>с адреса %1 приходят только повреждённые ответы</translation>
    </message>
    <message>
        <source>the answers from address %1 make no sense</source>
        <translation>ответы с адреса %1 не имеют смысла</translation>
    </message>
    <message>
        <source>the sensor with address %1 refuses</source>
        <translation>датчик с адресом %1 отказывает</translation>
    </message>
    <message>
        <source>the port is lost: %1</source>
        <translation>порт потерян: %1</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>прервано</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>нет ответа</translation>
    </message>
    <message>
        <source>damaged answers</source>
        <translation>повреждённые ответы</translation>
    </message>
    <message>
        <source>answers without sense</source>
        <translation>ответы без смысла</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>отказ</translation>
    </message>
    <message>
        <source>the port is lost</source>
        <translation>порт потерян</translation>
    </message>
    <message>
        <source>Commands:</source>
        <translation>Команды:</translation>
    </message>
    <message>
        <source>Exit codes: 0 done; 1 refused by the sensor or by the user; 2 the command line is wrong; 3 no answer, or the port cannot be opened.</source>
        <translation>Коды завершения: 0 — сделано; 1 — отказ датчика или пользователя; 2 — ошибка в командной строке; 3 — нет ответа или порт не открывается.</translation>
    </message>
    <message>
        <source>Examples:</source>
        <translation>Примеры:</translation>
    </message>
    <message>
        <source>One of the commands above.</source>
        <translation>Одна из команд выше.</translation>
    </message>
    <message>
        <source>The port.</source>
        <translation>Порт.</translation>
    </message>
    <message>
        <source>Speed; 115200 if not given. An ИН-Д3 comes with 9600 from the factory.</source>
        <translation>Скорость; по умолчанию 115200. ИН-Д3 с завода — 9600.</translation>
    </message>
    <message>
        <source>Parity; none if not given.</source>
        <translation>Чётность; по умолчанию нет.</translation>
    </message>
    <message>
        <source>Stop bits; 1 if not given.</source>
        <translation>Стоповые биты; по умолчанию 1.</translation>
    </message>
    <message>
        <source>The driver of the adapter switches the direction (RS485=1 in the ini).</source>
        <translation>Направление переключает драйвер адаптера (RS485=1 в ini).</translation>
    </message>
    <message>
        <source>Type of the sensor; needed where both have the command.</source>
        <translation>Тип датчика; нужен, если команда есть у обоих.</translation>
    </message>
    <message>
        <source>What an ИН-Д3 speaks; 2.11 if not given.</source>
        <translation>Протокол ИН-Д3; по умолчанию 2.11.</translation>
    </message>
    <message>
        <source>Address of the sensor, 1…255.</source>
        <translation>Адрес датчика, 1…255.</translation>
    </message>
    <message>
        <source>How long one answer is waited for; 200 if not given. It is asked for up to three times.</source>
        <translation>Сколько ждать одного ответа; по умолчанию 200. Запрос повторяется до трёх раз.</translation>
    </message>
    <message>
        <source>scan: the first address.</source>
        <translation>scan: первый адрес.</translation>
    </message>
    <message>
        <source>scan: the last address.</source>
        <translation>scan: последний адрес.</translation>
    </message>
    <message>
        <source>read: from one to the next; 1000 if not given.</source>
        <translation>read: от одного чтения до следующего; по умолчанию 1000.</translation>
    </message>
    <message>
        <source>set-averaging: ticks.</source>
        <translation>set-averaging: такты.</translation>
    </message>
    <message>
        <source>Writes without asking.</source>
        <translation>Запись без вопроса.</translation>
    </message>
    <message>
        <source>Prints JSON.</source>
        <translation>Печатает JSON.</translation>
    </message>
    <message>
        <source>Language of the program.</source>
        <translation>Язык программы.</translation>
    </message>
    <message>
        <source>Prints this.</source>
        <translation>Печатает эту справку.</translation>
    </message>
    <message>
        <source>Prints the version.</source>
        <translation>Печатает версию.</translation>
    </message>
    <message>
        <source>%1 %, %2 rows</source>
        <translation>%1 %, строк: %2</translation>
    </message>
    <message>
        <source>%1 rows: %2</source>
        <translation>строк %1: %2</translation>
    </message>
    <message>
        <source>cancelled; nothing was written</source>
        <translation>отменено, ничего не записано</translation>
    </message>
    <message>
        <source>--%1 is missing</source>
        <translation>не задан --%1</translation>
    </message>
    <message>
        <source>a day (2018-02-07) or a moment (2018-02-07T18:33:03)</source>
        <translation>день (2018-02-07) или момент (2018-02-07T18:33:03)</translation>
    </message>
    <message>
        <source>numbers and ranges of them (1,3,5-8), or all</source>
        <translation>номера и диапазоны номеров (1,3,5-8) или all</translation>
    </message>
    <message>
        <source>the site has no sensor %1</source>
        <translation>на объекте нет датчика %1</translation>
    </message>
    <message>
        <source>Writes what the archive of a site holds into a file.</source>
        <translation>Записывает данные из архива объекта в файл.</translation>
    </message>
    <message>
        <source>Quantities:</source>
        <translation>Величины:</translation>
    </message>
    <message>
        <source>The ini of the site.</source>
        <translation>Файл ini объекта.</translation>
    </message>
    <message>
        <source>The beginning, a day or a moment; without a zone it is local time.</source>
        <translation>Начало: день или момент; без указания пояса — местное время.</translation>
    </message>
    <message>
        <source>The end, not included; a day alone: its end.</source>
        <translation>Конец, не включается; если указан только день — конец этого дня.</translation>
    </message>
    <message>
        <source>Numbers of sensors, as 1,3,5-8; all if not given.</source>
        <translation>Номера датчиков, например 1,3,5-8; если не заданы — все.</translation>
    </message>
    <message>
        <source>As tilt-x,temperature; all but samples if not given.</source>
        <translation>Например, tilt-x,temperature; если не заданы — все, кроме отсчётов.</translation>
    </message>
    <message>
        <source>csv-ru if not given.</source>
        <translation>Если не задан — csv-ru.</translation>
    </message>
    <message>
        <source>A row for each reading, minute, hour or day; raw if not given.</source>
        <translation>Строка на каждое измерение, минуту, час или сутки; если не задано — raw.</translation>
    </message>
    <message>
        <source>The file; one that exists is replaced.</source>
        <translation>Файл; существующий заменяется.</translation>
    </message>
    <message>
        <source>Network code of miniSEED; XX if not given.</source>
        <translation>Код сети miniSEED; если не задан — XX.</translation>
    </message>
    <message>
        <source>Station code of miniSEED; from the name of the site if not given.</source>
        <translation>Код станции miniSEED; если не задан — по имени объекта.</translation>
    </message>
    <message>
        <source>Channel codes of X and Y in miniSEED; BN1,BN2 if not given.</source>
        <translation>Коды каналов X и Y в miniSEED; если не заданы — BN1,BN2.</translation>
    </message>
    <message>
        <source>JSON, one object a line; what is not known is null:
  every one      type (ind3, and3, usm), address
  scan, info     ind3: protocol, version, revision, serial, baud, name, offsetX, offsetY (arc-seconds),
                 ticks, period (ms), selfTest; and3: firmware, build, configuration (hexadecimal)
                 and the keys of read
  read           time (UTC), tiltX, tiltY (arc-seconds); and3: temperature (°C), fanFrequency (1/s),
                 heaterPower (%), rawStatus, rawMode, samples
  set-…, reset   setting (name, offset, ticks, period, address, reset), done; address: newAddress
  usm serial     serial; find: serial
  usm info       deviceType, serial, program, calibratedOn (dates), calibrations, channels (id, type, units,
                 description)
  usm value,     state (measured, out of range, sensor error), time (UTC), timestamp (s), serial, channel,
  usm records    measurement, value, variation (degrees), temperature (°C)
  usm …          setting (address, port, recorder), done; address: newAddress; port: isProbed
  a failure      fault: timeout, checksum, bad reply, refused, closed, cancelled</source>
        <translation>JSON, по объекту в строке; неизвестное — null:
  каждый объект  type (ind3, and3, usm), address
  scan, info     ind3: protocol, version, revision, serial, baud, name, offsetX, offsetY (угл. сек.),
                 ticks, period (мс), selfTest; and3: firmware, build, configuration (шестнадцатеричное)
                 и ключи read
  read           time (UTC), tiltX, tiltY (угл. сек.); and3: temperature (°C), fanFrequency (1/с),
                 heaterPower (%), rawStatus, rawMode, samples
  set-…, reset   setting (name, offset, ticks, period, address, reset), done; address: newAddress
  usm serial     serial; find: serial
  usm info       deviceType, serial, program, calibratedOn (даты), calibrations, channels (id, type, units,
                 description)
  usm value,     state (measured, out of range, sensor error), time (UTC), timestamp (с), serial, channel,
  usm records    measurement, value, variation (градусы), temperature (°C)
  usm …          setting (address, port, recorder), done; address: newAddress; port: isProbed
  неудача        fault: timeout, checksum, bad reply, refused, closed, cancelled</translation>
    </message>
    <message>
        <source>Finds, reads and sets ИН-Д3, АН-Д3 and УСМ-ИСН sensors on a serial line. The line must not be open in another program.</source>
        <translation>Находит, читает и настраивает датчики ИН-Д3, АН-Д3 и УСМ-ИСН на последовательной линии. Линия не должна быть открыта в другой программе.</translation>
    </message>
    <message>
        <source>read: how many times; 0: until Ctrl+C. Once if not given. usm records: of the last N only, 1…999; 0 or not given: of all.</source>
        <translation>read: сколько раз; 0 — до Ctrl+C. Без ключа — один раз. usm records: только из последних N, 1…999; 0 или без ключа — из всех.</translation>
    </message>
    <message>
        <source>set-averaging: period in ms. usm start-cycle: 900…43200 s.</source>
        <translation>set-averaging: период в мс. usm start-cycle: 900…43200 с.</translation>
    </message>
    <message>
        <source>usm value, usm records: 1 is X, 2 is Y.</source>
        <translation>usm value, usm records: 1 — X, 2 — Y.</translation>
    </message>
    <message>
        <source>usm value: the device keeps the measurement with the time of now.</source>
        <translation>usm value: устройство запоминает измерение с текущим временем.</translation>
    </message>
    <message>
        <source>usm records: all (if not given), or those not yet read.</source>
        <translation>usm records: все (без ключа) или ещё не прочитанные.</translation>
    </message>
    <message>
        <source>usm start-cycle: seconds to the first measurement; 10 if not given.</source>
        <translation>usm start-cycle: секунд до первого измерения; без ключа 10.</translation>
    </message>
    <message>
        <source>usm start-cycle: seconds before each measurement, 0…600; 0 if not given.</source>
        <translation>usm start-cycle: секунд перед каждым измерением, 0…600; без ключа 0.</translation>
    </message>
    <message>
        <source>The device %1 has the address %2.</source>
        <translation>У устройства %1 адрес %2.</translation>
    </message>
    <message>
        <source>the device %1 does not answer (%2)</source>
        <translation>устройство %1 не отвечает (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%n record(s)</source>
        <translation>
            <numerusform>%n запись</numerusform>
            <numerusform>%n записи</numerusform>
            <numerusform>%n записей</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n measurement(s) missing</source>
        <translation>
            <numerusform>не хватает %n измерения</numerusform>
            <numerusform>не хватает %n измерений</numerusform>
            <numerusform>не хватает %n измерений</numerusform>
        </translation>
    </message>
    <message>
        <source>УСМ-ИСН: looks for devices at the addresses 1…255</source>
        <translation>УСМ-ИСН: ищет устройства по адресам 1…255</translation>
    </message>
    <message>
        <source>looks for the device with this serial number</source>
        <translation>ищет устройство с этим серийным номером</translation>
    </message>
    <message>
        <source>prints the serial number</source>
        <translation>выводит серийный номер</translation>
    </message>
    <message>
        <source>prints what the device is, its calibration and channels</source>
        <translation>выводит сведения об устройстве, его калибровке и каналах</translation>
    </message>
    <message>
        <source>measures now, about 1.5 s a channel</source>
        <translation>измеряет сейчас, около 1,5 с на канал</translation>
    </message>
    <message>
        <source>prints the records of the device; up to some minutes at 9600</source>
        <translation>выводит записи устройства; на скорости 9600 до нескольких минут</translation>
    </message>
    <message>
        <source>makes it a recorder, which sleeps and does not answer any more</source>
        <translation>делает его регистратором: он спит и больше не отвечает</translation>
    </message>
    <message>
        <source>wakes a recorder, up to two minutes</source>
        <translation>будит регистратор, до двух минут</translation>
    </message>
    <message>
        <source>gives the device another address</source>
        <translation>назначает устройству другой адрес</translation>
    </message>
    <message>
        <source>gives the device another speed, N|E|O, 1|1.5|2, and looks whether it answers there</source>
        <translation>назначает устройству другую скорость, N|E|O, 1|1.5|2 и проверяет, отвечает ли оно</translation>
    </message>
    <message>
        <source>port settings are 110…115200, N or E or O, 1 or 1.5 or 2, not &quot;%1&quot;</source>
        <translation>настройки порта — 110…115200, N, E или O, 1, 1.5 или 2, а не «%1»</translation>
    </message>
    <message>
        <source>a serial number has up to eight digits, not &quot;%1&quot;</source>
        <translation>в серийном номере до восьми цифр, а не «%1»</translation>
    </message>
    <message>
        <source>temperature %1 °C</source>
        <translation>температура %1 °C</translation>
    </message>
    <message>
        <source>out of range</source>
        <translation>вне диапазона</translation>
    </message>
    <message>
        <source>the device cannot measure; its transducer may be broken</source>
        <translation>устройство не может измерить; возможно, неисправен его преобразователь</translation>
    </message>
    <message>
        <source>serial number %1, not an УСМ-ИСН (type %2)</source>
        <translation>серийный номер %1, не УСМ-ИСН (тип %2)</translation>
    </message>
    <message>
        <source>serial number %1, calibrated on %2</source>
        <translation>серийный номер %1, калибровка %2</translation>
    </message>
    <message>
        <source>address: %1</source>
        <translation>адрес: %1</translation>
    </message>
    <message>
        <source>type: %1</source>
        <translation>тип: %1</translation>
    </message>
    <message>
        <source>serial number: %1</source>
        <translation>серийный номер: %1</translation>
    </message>
    <message>
        <source>program of: %1</source>
        <translation>программа от: %1</translation>
    </message>
    <message>
        <source>calibrated on: %1</source>
        <translation>калибровка: %1</translation>
    </message>
    <message>
        <source>calibrations: %1</source>
        <translation>калибровок: %1</translation>
    </message>
    <message>
        <source>channel %1: %2, %3, %4</source>
        <translation>канал %1: %2, %3, %4</translation>
    </message>
    <message>
        <source>the device refuses these port settings; nothing was changed</source>
        <translation>устройство отвергает эти настройки порта; ничего не изменено</translation>
    </message>
    <message>
        <source>the device still answers at the old port settings</source>
        <translation>устройство по-прежнему отвечает при старых настройках порта</translation>
    </message>
    <message>
        <source>no answer, neither at the old nor at the new port settings; switch the device off and on, it listens at 9600-N-1 for its first second</source>
        <translation>нет ответа ни при старых, ни при новых настройках порта; выключите и включите устройство, первую секунду оно слушает на 9600-N-1</translation>
    </message>
    <message>
        <source>what became of the port settings is not known (%1)</source>
        <translation>что стало с настройками порта, неизвестно (%1)</translation>
    </message>
    <message>
        <source>Make the device with address %1 a recorder, every %2 s? It sleeps until stop-cycle, or until it is without power for over a minute.</source>
        <translation>Сделать устройство с адресом %1 регистратором с периодом %2 с? Оно будет спать до stop-cycle или пока не останется без питания дольше минуты.</translation>
    </message>
    <message>
        <source>The device records.</source>
        <translation>Устройство записывает.</translation>
    </message>
    <message>
        <source>waiting for the recorder to wake, %1 s…</source>
        <translation>ожидание пробуждения регистратора, %1 с…</translation>
    </message>
    <message>
        <source>The device does not record any more.</source>
        <translation>Устройство больше не записывает.</translation>
    </message>
    <message>
        <source>Give the device with address %1 other port settings?</source>
        <translation>Назначить устройству с адресом %1 другие настройки порта?</translation>
    </message>
    <message>
        <source>The device answers at its new port settings.</source>
        <translation>Устройство отвечает при новых настройках порта.</translation>
    </message>
    <message>
        <source>The device has taken its new port settings; this line cannot try them.</source>
        <translation>Устройство приняло новые настройки порта; на этой линии их нельзя проверить.</translation>
    </message>
    <message>
        <source>The folder with History; the folder of the configuration if not given.</source>
        <translation>Папка, где лежит History; без ключа — папка конфигурации.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2. Name the configuration with --config.</source>
        <translation>Не удаётся прочитать %1: %2. Укажите конфигурацию ключом --config.</translation>
    </message>
    <message>
        <source>gorizont-tool archive --help and gorizont-tool export --help tell of the archive of readings.</source>
        <translation>Об архиве показаний рассказывают gorizont-tool archive --help и gorizont-tool export --help.</translation>
    </message>
    <message>
        <source>%1 is not a table of records; name another file</source>
        <translation>%1 — не таблица записей; укажите другой файл</translation>
    </message>
    <message>
        <source>usm records: the table that is written; one that is there is continued, each record once.</source>
        <translation>usm records: таблица для записи; существующая продолжается, каждая запись один раз.</translation>
    </message>
    <message>
        <source>Looks after the archive of Gorizont Server; the server may run meanwhile, only not for import-history.</source>
        <translation>Обслуживает архив Gorizont Server; сервер при этом может работать, но не при import-history.</translation>
    </message>
    <message>
        <source>check               reads all of it and compares every check sum
stat                prints what is in it
backup TARGET       copies it as it is at this moment to a file that does not exist yet
import-history DIR  takes over the text and binary files of the folder History where the archive knows nothing</source>
        <translation>check                 читает его целиком и сверяет все контрольные суммы
stat                  выводит, что в нём есть
backup ЦЕЛЬ           копирует его в нынешнем виде в файл, которого ещё нет
import-history ПАПКА  переносит текстовые и двоичные файлы папки History за то время, о котором архив ничего не знает</translation>
    </message>
    <message>
        <source>Exit codes: 0 done; 1 it is damaged, or cannot be read, copied or written; 2 the command line is wrong.</source>
        <translation>Коды завершения: 0 — сделано; 1 — повреждён, не читается, не копируется или не записывается; 2 — ошибка в командной строке.</translation>
    </message>
    <message>
        <source>The file; if not given, History/archive.sqlite, and for import-history the archive of the configuration.</source>
        <translation>Файл; если не указан — History/archive.sqlite, а для import-history — архив конфигурации.</translation>
    </message>
    <message>
        <source>archive takes check, stat, backup TARGET or import-history DIR; see gorizont-tool archive --help</source>
        <translation>archive принимает check, stat, backup ЦЕЛЬ или import-history ПАПКА; см. gorizont-tool archive --help</translation>
    </message>
    <message>
        <source>%1 files, %2 records, %3 damaged lines; %4 values of sensors were new</source>
        <translation>файлов: %1, записей: %2, повреждённых строк: %3; новых показаний датчиков: %4</translation>
    </message>
    <message>
        <source>import-history: the configuration with the sensors of the files; GorizontServer.ini if not given.</source>
        <translation>import-history: конфигурация с датчиками этих файлов; если не указана — GorizontServer.ini.</translation>
    </message>
    <message>
        <source>import-history: the folder of the archive&apos;s History; the folder of the configuration if not given.</source>
        <translation>import-history: папка, в которой History с архивом; если не указана — папка конфигурации.</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>gorizont-tool vims --help tells of L-VIMS vibration modules.</source>
        <translation>О модулях измерения вибрации L-VIMS рассказывает gorizont-tool vims --help.</translation>
    </message>
    <message>
        <source>vims takes one of %1; see gorizont-tool vims --help</source>
        <translation>vims принимает одно из: %1; см. gorizont-tool vims --help</translation>
    </message>
    <message>
        <source>--device takes tcp://host:port, not &quot;%1&quot;</source>
        <translation>--device принимает tcp://host:port, а не «%1»</translation>
    </message>
    <message>
        <source>--type takes 5000 or 200, not &quot;%1&quot;</source>
        <translation>--type принимает 5000 или 200, а не «%1»</translation>
    </message>
    <message>
        <source>Reads an L-VIMS vibration module over the network; others may read it meanwhile.</source>
        <translation>Читает модуль измерения вибрации L-VIMS по сети; другие могут читать его в то же время.</translation>
    </message>
    <message>
        <source>A .csv has the columns time (s), code and value, or frequency (Hz) and amplitude. A .wav is scaled so that its largest value is 1.</source>
        <translation>В .csv столбцы time (с), code и value или frequency (Гц) и amplitude. В .wav наибольшее значение приведено к 1.</translation>
    </message>
    <message>
        <source>Exit codes: 0 done; 1 refused by the module or by the user; 2 the command line is wrong; 3 no answer, or no connection.</source>
        <translation>Коды завершения: 0 — сделано; 1 — отказ модуля или пользователя; 2 — ошибка в командной строке; 3 — нет ответа или связи.</translation>
    </message>
    <message>
        <source>The module; port 502 if none is given.</source>
        <translation>Модуль; порт 502, если не указан другой.</translation>
    </message>
    <message>
        <source>Unit of Modbus; 1 if not given.</source>
        <translation>Адрес Modbus; если не указан — 1.</translation>
    </message>
    <message>
        <source>How long one answer is waited for; %1 if not given.</source>
        <translation>Сколько ждать одного ответа; если не указано — %1.</translation>
    </message>
    <message>
        <source>waveform, spectrum: 0…3; 0 if not given.</source>
        <translation>waveform, spectrum: 0…3; если не указан — 0.</translation>
    </message>
    <message>
        <source>spectrum: up to 5000 (if not given) or 200 Hz.</source>
        <translation>spectrum: до 5000 Гц (если не указано) или до 200 Гц.</translation>
    </message>
    <message>
        <source>waveform, spectrum: the file, .csv or, of a waveform, .wav.</source>
        <translation>waveform, spectrum: файл .csv, для выборки также .wav.</translation>
    </message>
    <message>
        <source>settings: writes them to this file.</source>
        <translation>settings: записывает их в этот файл.</translation>
    </message>
    <message>
        <source>settings: writes this file to the module and lets it use them.</source>
        <translation>settings: записывает этот файл в модуль и применяет.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 из %2</translation>
    </message>
    <message>
        <source>The settings are in %1.</source>
        <translation>Настройки сохранены в %1.</translation>
    </message>
    <message>
        <source>%1 is no file of settings</source>
        <translation>%1 — не файл настроек</translation>
    </message>
    <message>
        <source>nothing was written. --yes writes without asking</source>
        <translation>ничего не записано. С --yes запись идёт без вопроса</translation>
    </message>
    <message>
        <source>The module uses the settings of %1.</source>
        <translation>Модуль работает с настройками из %1.</translation>
    </message>
    <message>
        <source>All settings of the module change, its network address too. Write them?</source>
        <translation>Изменятся все настройки модуля, в том числе его сетевой адрес. Записать?</translation>
    </message>
    <message>
        <source>boot loader</source>
        <translation>загрузчик</translation>
    </message>
    <message>
        <source>at work</source>
        <translation>работа</translation>
    </message>
    <message>
        <source>%1, serial number %2, program %3, board %4, %5</source>
        <translation>%1, заводской номер %2, программа %3, плата %4, %5</translation>
    </message>
    <message>
        <source>channel %1: %2</source>
        <translation>канал %1: %2</translation>
    </message>
    <message>
        <source>relay %1: logical %2, physical %3, error %4, enabled %5</source>
        <translation>реле %1: логическое %2, физическое %3, ошибка %4, включено %5</translation>
    </message>
    <message>
        <source>channel %1: %2 samples, %3 Hz</source>
        <translation>канал %1: отсчётов %2, %3 Гц</translation>
    </message>
    <message>
        <source>channel %1: %2 bins, highest %3 at %4 Hz</source>
        <translation>канал %1: линий %2, наибольшая %3 на %4 Гц</translation>
    </message>
    <message>
        <source>the module refuses the settings (LAST_WR_ERROR %1, LAST_CHECK_SETTINGS_ERR %2); it keeps those it had</source>
        <translation>модуль отказывается от настроек (LAST_WR_ERROR %1, LAST_CHECK_SETTINGS_ERR %2); у него остались прежние</translation>
    </message>
    <message>
        <source>JSON, one object a line; what the station did not send, or sent as not valid, is absent:
  every one   type (MK-14), device, address
  read        cmd, digital, parameters: code, number, name, unit, mean, instant, min, max, voltage,
              voltageInstant, maxPeriod, deviation; events: start, time (s)
  set-…,      setting (time, outputs, file), done; time: seconds since 1970 that were sent; outputs, digital;
  send-file   file, name
  a failure   fault: timeout, checksum, bad reply, refused, closed, cancelled</source>
        <translation>JSON, по объекту в строке; чего станция не передала или передала негодным, того нет:
  каждый      type (MK-14), device, address
  read        cmd, digital, parameters: code, number, name, unit, mean, instant, min, max, voltage,
              voltageInstant, maxPeriod, deviation; events: start, time (с)
  set-…,      setting (time, outputs, file), done; time: переданные секунды с 1970 года; outputs, digital;
  send-file   file, name
  неудача     fault: timeout, checksum, bad reply, refused, closed, cancelled</translation>
    </message>
    <message>
        <source>mk14 takes one of %1; see gorizont-tool mk14 --help</source>
        <translation>после mk14 нужно одно из: %1; см. gorizont-tool mk14 --help</translation>
    </message>
    <message>
        <source>outputs are a number like 5 or 0x0005, not &quot;%1&quot;</source>
        <translation>слово выходов — число, например 5 или 0x0005, а не «%1»</translation>
    </message>
    <message>
        <source>Reads and sets a weather station МК-14. The line must not be open in another program.</source>
        <translation>Читает и настраивает метеостанцию МК-14. Линия не должна быть открыта другой программой.</translation>
    </message>
    <message>
        <source>read         prints what it measures, by --cmd
set-time     sets its clock to that of this computer
set-outputs  gives its outputs the control word WORD, like 5 or 0x0005
send-file    sends it a settings file like ACK.PAR</source>
        <translation>read         печатает, что она измеряет, командой --cmd
set-time     ставит её часы по часам этого компьютера
set-outputs  задаёт управляющее слово выходов WORD, например 5 или 0x0005
send-file    передаёт ей файл настройки, например ACK.PAR</translation>
    </message>
    <message>
        <source>Every question carries the control word of the outputs: give read the one that shall stay with --outputs. A server that polls the station repeats its own, Outputs{i} of the ini.</source>
        <translation>Управляющее слово выходов есть в каждом запросе: для read задайте ключом --outputs то, которое должно остаться. Сервер, который опрашивает станцию, повторяет своё — Outputs{i} из ini.</translation>
    </message>
    <message>
        <source>Exit codes: 0 done; 1 refused by the user, or impossible; 2 the command line is wrong; 3 no answer, not confirmed, or the port cannot be opened.</source>
        <translation>Коды выхода: 0 сделано; 1 отказ пользователя или невозможно; 2 ошибка в командной строке; 3 нет ответа, не подтверждено или порт не открывается.</translation>
    </message>
    <message>
        <source>Speed; %1 if not given.</source>
        <translation>Скорость; если не задана — %1.</translation>
    </message>
    <message>
        <source>Data bits; 8 if not given.</source>
        <translation>Биты данных; если не заданы — 8.</translation>
    </message>
    <message>
        <source>Address of the station, 1…255; 1 if not given.</source>
        <translation>Адрес станции, 1…255; если не задан — 1.</translation>
    </message>
    <message>
        <source>read: data command, 1…8; 4 if not given.</source>
        <translation>read: команда, 1…8; если не задана — 4.</translation>
    </message>
    <message>
        <source>Codes of its parameters in order; U,T,P,H,A,M if not given.</source>
        <translation>Коды её параметров по порядку; если не заданы — U,T,P,H,A,M.</translation>
    </message>
    <message>
        <source>Its ACK.PAR file, which has their codes, names and units.</source>
        <translation>Её файл ACK.PAR: коды, названия и единицы.</translation>
    </message>
    <message>
        <source>read: control word of the outputs; 0 if not given.</source>
        <translation>read: управляющее слово выходов; если не задано — 0.</translation>
    </message>
    <message>
        <source>set-time: the clock of the station shows UTC, not local time.</source>
        <translation>set-time: часы станции показывают UTC, а не местное время.</translation>
    </message>
    <message>
        <source>send-file: the name that the station gets; that of the file if not given.</source>
        <translation>send-file: имя, под которым файл получит станция; если не задано — имя файла.</translation>
    </message>
    <message>
        <source>not confirmed (%1)</source>
        <translation>не подтверждено (%1)</translation>
    </message>
    <message>
        <source>Set the clock of station %1?</source>
        <translation>Поставить часы станции %1?</translation>
    </message>
    <message>
        <source>The clock of the station shows %1.</source>
        <translation>Часы станции показывают %1.</translation>
    </message>
    <message>
        <source>Give the outputs of station %1 the word %2?</source>
        <translation>Задать выходам станции %1 слово %2?</translation>
    </message>
    <message>
        <source>The outputs have the word %1. A server that polls the station must have it as Outputs{i} too.</source>
        <translation>У выходов слово %1. У сервера, который опрашивает станцию, оно должно стоять и в Outputs{i}.</translation>
    </message>
    <message>
        <source>longer than 64 KiB</source>
        <translation>длиннее 64 КиБ</translation>
    </message>
    <message>
        <source>Send %1 to station %2?</source>
        <translation>Передать %1 станции %2?</translation>
    </message>
    <message>
        <source>The station has %1.</source>
        <translation>%1 у станции.</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>среднее</translation>
    </message>
    <message>
        <source>now</source>
        <translation>сейчас</translation>
    </message>
    <message>
        <source>min</source>
        <translation>мин.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>макс.</translation>
    </message>
    <message>
        <source>max of the period</source>
        <translation>макс. за срок</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>напряжение</translation>
    </message>
    <message>
        <source>voltage now</source>
        <translation>напряжение сейчас</translation>
    </message>
    <message>
        <source>precipitation began %1</source>
        <translation>осадки начались %1</translation>
    </message>
    <message>
        <source>precipitation ended %1</source>
        <translation>осадки кончились %1</translation>
    </message>
    <message>
        <source>the station has no data</source>
        <translation>у станции нет данных</translation>
    </message>
    <message>
        <source>digital inputs: %1</source>
        <translation>цифровые входы: %1</translation>
    </message>
    <message>
        <source>gorizont-tool mk14 --help tells of МК-14 weather stations.</source>
        <translation>О метеостанциях МК-14 — gorizont-tool mk14 --help.</translation>
    </message>
    <message>
        <source>JSON, one object a line; what is not known is null:
  every one   type (L-VIMS), device
  info        name, serial, firmware, board, mode (1 boot loader, 2 at work), writeError, settingsError
  state       channels: channel (0…3), state (0 good, 1 short circuit, 2 break, 65535 no data), measurements:
              index, type, value, percent, fault, warning, stop, baselineValid, baselineExceeded; relays:
              index, logical, physical, error, enabled
  waveform    channel, id, samples, rate (Hz), disturbances, file
  spectrum    channel, spectrum (5000, 200), bins, rate (Hz), disturbances, peakFrequency (Hz),
              peakAmplitude, file
  settings    setting (settings), done, file; load: writeError, settingsError; show: values (name: value in
              use), differences: name, current, changed; set, apply, flash: changes: name, before, after;
              applied, flash, writeError, settingsError
  reload, reboot  setting, done; reload: writeError, settingsError
  a failure   fault: timeout, checksum, bad reply, refused, closed, cancelled</source>
        <translation>JSON, по объекту на строку; чего не знают — null:
  каждый      type (L-VIMS), device
  info        name, serial, firmware, board, mode (1 загрузчик, 2 рабочий), writeError, settingsError
  state       channels: channel (0…3), state (0 исправен, 1 замыкание, 2 обрыв, 65535 нет данных), measurements:
              index, type, value, percent, fault, warning, stop, baselineValid, baselineExceeded; relays:
              index, logical, physical, error, enabled
  waveform    channel, id, samples, rate (Гц), disturbances, file
  spectrum    channel, spectrum (5000, 200), bins, rate (Гц), disturbances, peakFrequency (Гц),
              peakAmplitude, file
  settings    setting (settings), done, file; load: writeError, settingsError; show: values (имя: действующее
              значение), differences: name, current, changed; set, apply, flash: changes: name, before, after;
              applied, flash, writeError, settingsError
  reload, reboot  setting, done; reload: writeError, settingsError
  неудача     fault: timeout, checksum, bad reply, refused, closed, cancelled</translation>
    </message>
    <message>
        <source>--set takes NAME=VALUE with a name that --show prints, not &quot;%1&quot;</source>
        <translation>--set принимает ИМЯ=ЗНАЧЕНИЕ с именем, которое печатает --show, а не «%1»</translation>
    </message>
    <message>
        <source>vims settings takes one of --show, --save FILE, --load FILE and --set NAME=VALUE, the last with --apply and --flash, which may stand alone</source>
        <translation>vims settings принимает одно из --show, --save ФАЙЛ, --load ФАЙЛ и --set ИМЯ=ЗНАЧЕНИЕ, последнее с --apply и --flash, которые могут стоять и одни</translation>
    </message>
    <message>
        <source>info       prints what the module is
state      prints what it measures, and its relays
waveform   lets it keep a waveform, fetches it and writes it to --out
spectrum   the same for its spectrum up to 5000 Hz or 200 Hz
settings   shows its settings, changes single ones, or writes them to a file and back
reload     lets it use the settings of its flash again
reboot     restarts it</source>
        <translation>info       печатает, что это за модуль
state      печатает, что он измеряет, и его реле
waveform   фиксирует выборку, читает её и пишет в --out
spectrum   то же для спектра до 5000 Гц или 200 Гц
settings   показывает настройки, меняет отдельные или пишет их в файл и обратно
reload     возвращает модуль к настройкам из flash
reboot     перезапускает его</translation>
    </message>
    <message>
        <source>settings: prints those in use, and those prepared where they differ.</source>
        <translation>settings: печатает действующие и, где они отличаются, подготовленные.</translation>
    </message>
    <message>
        <source>settings: prepares one, such as CH1.SENSOR_K=100 or CH0.MEAS3.IIR_LP.FC=200.5; may be repeated.</source>
        <translation>settings: подготавливает одну, например CH1.SENSOR_K=100 или CH0.MEAS3.IIR_LP.FC=200.5; можно повторять.</translation>
    </message>
    <message>
        <source>settings: lets the module use those prepared.</source>
        <translation>settings: модуль начинает пользоваться подготовленными.</translation>
    </message>
    <message>
        <source>settings: keeps them for the next start of the module too.</source>
        <translation>settings: сохраняет их и для следующего запуска модуля.</translation>
    </message>
    <message>
        <source>Prepared and not in use (value in use → value prepared):</source>
        <translation>Подготовлено и не действует (действующее → подготовленное):</translation>
    </message>
    <message>
        <source>The network address of the module changes: this connection will be lost.</source>
        <translation>Сетевой адрес модуля меняется: эта связь прервётся.</translation>
    </message>
    <message>
        <source>The module keeps its prepared settings for its next start.</source>
        <translation>Модуль сохранит подготовленные настройки для следующего запуска.</translation>
    </message>
    <message>
        <source>Write them?</source>
        <translation>Записать?</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Готово.</translation>
    </message>
    <message>
        <source>The module uses the settings of its flash from now on; what was only applied is lost. Go on?</source>
        <translation>Модуль перейдёт на настройки из flash; только применённое пропадёт. Продолжить?</translation>
    </message>
    <message>
        <source>The module uses the settings of its flash.</source>
        <translation>Модуль пользуется настройками из flash.</translation>
    </message>
    <message>
        <source>The module restarts; it measures nothing and switches no relay meanwhile. Go on?</source>
        <translation>Модуль перезапустится; в это время он не измеряет и не переключает реле. Продолжить?</translation>
    </message>
    <message>
        <source>The module restarts.</source>
        <translation>Модуль перезапускается.</translation>
    </message>
</context>
</TS>
