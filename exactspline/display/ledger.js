const form=document.querySelector("form"),rows=[...document.querySelectorAll("tbody tr")];
function filter(){const d=new FormData(form),text=d.get("text").toLowerCase();let n=0;
for(const r of rows){const ok=["verdict","section","curve"].every(k=>!d.get(k)||r.dataset[k]===d.get(k))
&&(!text||r.textContent.toLowerCase().includes(text));r.hidden=!ok;n+=ok}
document.querySelector("output").textContent=n+" of "+rows.length+" rows"}
form.addEventListener("input",filter);form.addEventListener("submit",e=>e.preventDefault());filter();
