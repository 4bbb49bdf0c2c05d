// node duckdb.cjs SQL...: runs the statements, and prints their rows, with commas between the values.
const { DuckDBInstance } = require('@duckdb/node-api');

(async () => {
  const database = await (await DuckDBInstance.create()).connect();
  for (const sql of process.argv.slice(2)) {
    const rows = (await database.runAndReadAll(sql)).getRows();
    if (!/^COPY/.test(sql)) for (const row of rows) console.log(row.join());
  }
})();
