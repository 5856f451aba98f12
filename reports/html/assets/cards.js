// Cards open when a link leads to them; pictures enlarge.
function openTarget() {
  const target = location.hash.startsWith("#design-") && document.querySelector(location.hash);
  if (target && "open" in target) target.open = true;
}

function setUpLightbox() {
  const box = document.getElementById("lightbox");
  const [image, text] = [box.querySelector("img"), box.querySelector("p")];
  for (const button of document.querySelectorAll("button.zoom")) {
    button.addEventListener("click", () => {
      const small = button.querySelector("img");
      image.src = small.src;
      image.alt = small.alt;
      text.textContent = `${small.alt}, ${button.parentElement.querySelector("figcaption").textContent}`;
      box.showModal();
    });
  }
  box.addEventListener("click", (event) => { if (event.target !== image) box.close(); });
}

export function setUpCards(resize) {
  openTarget();
  addEventListener("hashchange", openTarget);
  addEventListener("resize", resize);
  const cards = [...document.querySelectorAll("details.card")];
  const button = document.getElementById("open-all");
  button?.addEventListener("click", () => {
    const open = cards.some((card) => !card.open);
    cards.forEach((card) => { card.open = open; });
    button.textContent = open ? "Close all" : "Open all";
  });
  setUpLightbox();
}
