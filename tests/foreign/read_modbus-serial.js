// Reads registers with modbus-serial: PORT UNIT:FUNCTION:START:COUNT…; see test_foreign.py.
const Modbus = require("modbus-serial");

async function main() {
    const [port, ...wanted] = process.argv.slice(2);
    const client = new Modbus();
    client.setTimeout(10000);
    await client.connectTCP("127.0.0.1", { port: Number(port) });
    const answers = [];
    for (const what of wanted) {
        const [unit, functionCode, start, count] = what.split(":").map(Number);
        client.setID(unit);
        const read = functionCode === 3 ? client.readHoldingRegisters : client.readInputRegisters;
        try {
            answers.push((await read.call(client, start, count)).data);
        } catch (error) {
            if (!error.modbusCode) {
                throw error;
            }
            answers.push({ exception: error.modbusCode });
        }
    }
    client.close();
    console.log(JSON.stringify(answers));
}

main();
