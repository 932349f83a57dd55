<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Watches buildings: polls inclinometers and accelerometers, shows, saves and serves their readings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3. It comes without any warranty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built with Qt %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PortPage</name>
    <message>
        <source>Comment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polling time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long polled without a break</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time since opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts to open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>those that failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Code of the last error</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SensorPage</name>
    <message>
        <source>modulus of the maximum, its direction, degrees (RMS of the modulus | along X, along Y), packets in the sensor : read (samples) saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>maximum along X %1, along Y %2 mm/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flags of the state : of the mode, as the sensor gives them; the program&apos;s own word is %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angles Mx, My, degrees (arc-seconds)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accelerations Ax, Ay, mm/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature T, °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wind speed U, V, m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thermostat, % (rev/s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>power of the heater (frequency of the fan)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Status word</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polling period, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>period | time of the exchange | age of the values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>the file gives “%1”, which cannot be used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[Server]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IP port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modbus TCP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modbus TCP, switched off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>period of the visible elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>period of polling a port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time for resources at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>period of the records in the files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slice of any pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after a failed attempt to open a port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after closing a port, before it is opened again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time for an orderly end of the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after another address is chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after a polling cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after a read error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after a CRC error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading the answer to a command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing a command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read errors in a row before the status word says so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CRC errors in a row before the status word says so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[More]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save to files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Records cleared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide to the tray at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warn at the end of work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow a second copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow adjustment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accelerometer&apos;s buffer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 packets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>32 samples of both axes each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[Port]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 baud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[Sensor]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number on the site</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address on the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>[Adjustment]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset Mx, degrees (arc-seconds)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset My, degrees (arc-seconds)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset T, °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inversion of axis Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation of axis X, degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date of installation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date of the last adjustment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remark</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>restarted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples were lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples do not follow each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tilt is not ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature is not ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acceleration is not ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the thermostat has not settled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open, polling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Service mode, polling is suspended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The port is off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CRC errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The transducer does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CRC errors of the transducer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The transducer is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The temperature sensor does not work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The temperature sensor is out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fan does not work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The thermostat takes too long to settle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown type of sensor, not polled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polling is off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the first answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answering: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything works</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Service mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensors good: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with errors: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with warnings: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>starting: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in service: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(line %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::AttentionBanner</name>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n sensor(s) need attention</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>gorizont::ComplaintsDialog</name>
    <message>
        <source>Configuration file</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the configuration file cannot be used as they are. The program works without them.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::FirstRunDialog</name>
    <message>
        <source>Gorizont Server: first start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no configuration file GorizontServer.ini yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was looked for here:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A simulated site with sensors; no equipment is needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a configuration file that already exists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Configuration file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Configuration files (*.ini);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::InfoPanel</name>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Journal</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::JournalPage</name>
    <message>
        <source>Errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Information</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::MainWindow</name>
    <message>
        <source>End the work of the program?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polling of the sensors, records and the data server will stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Sensors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;ort</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;ensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Se&amp;ttings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measurements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Journal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::MeasurementModel</name>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: X, ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: Y, ″</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: T, °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: P, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: status</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::PortModel</name>
    <message>
        <source>How long the port has been open, h:mm:ss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed attempts to open the port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Received</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::PropertyModel</name>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::SensorModel</name>
    <message>
        <source>Angle along X, degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle along Y, degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum acceleration, mm/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square of the acceleration, mm/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature, °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency of the thermostat&apos;s fan, revolutions per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power of the thermostat&apos;s heater, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Status word of the sensor: the code, then bits 11…0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mx, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My, °</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amax, mm/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arms, mm/s²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T, °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frequency, rev/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Status</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::SiteTree</name>
    <message>
        <source>Find a sensor (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::SiteTreeModel</name>
    <message>
        <source>Server</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::StatePanel</name>
    <message>
        <source>Ports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::TableView</name>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>gorizont::TrayIcon</name>
    <message>
        <source>&amp;Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
