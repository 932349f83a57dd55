// Reads registers with jsmodbus: PORT UNIT:FUNCTION:START:COUNT…; see test_foreign.py.
const net = require("net");
const Modbus = require("jsmodbus");

/// A client of jsmodbus belongs to one unit, so every question has a connection of its own.
async function ask(port, unit, functionCode, start, count) {
    const socket = net.connect(port, "127.0.0.1");
    const client = new Modbus.client.TCP(socket, unit, 10000);
    await new Promise((connected, failed) => socket.once("connect", connected).once("error", failed));
    const read = functionCode === 3 ? client.readHoldingRegisters : client.readInputRegisters;
    try {
        return (await read.call(client, start, count)).response.body.valuesAsArray;
    } catch (error) {
        if (error.err !== "ModbusException") {
            throw error;
        }
        return { exception: error.response.body.code };
    } finally {
        socket.end();
    }
}

async function main() {
    const [port, ...wanted] = process.argv.slice(2);
    const answers = [];
    for (const what of wanted) {
        answers.push(await ask(Number(port), ...what.split(":").map(Number)));
    }
    console.log(JSON.stringify(answers));
}

main();
