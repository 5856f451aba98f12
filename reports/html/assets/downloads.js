// The data of this page as files, made in the browser: nothing is fetched.
function save(name, type, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

export function setUpDownloads(data) {
  const stem = data.name.replace(/[^\w-]+/g, "_") || "study";
  const { csv, ...rest } = data;
  document.getElementById("download-csv")?.addEventListener("click", () => save(`${stem}.csv`, "text/csv", csv));
  document.getElementById("download-json")?.addEventListener("click", () =>
    save(`${stem}.json`, "application/json", JSON.stringify(rest, null, 1)));
}
