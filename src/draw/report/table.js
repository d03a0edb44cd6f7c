'use strict';
// SPDX-License-Identifier: GPL-3.0-or-later
// Fills a table and makes its columns sortable.
// columns: [{ label, value(row), text(row)?, cell(td, row)?, number? }]
// options: { onRow(tr, row)?, isLong? }: of a long table come the next rows when the last is in sight,
// and all when it is sorted or printed
// Returns { filter(predicate), rows: Map(row -> tr) }.
function fillTable(table, columns, rows, options) {
  const collator = new Intl.Collator('en', { numeric: true, sensitivity: 'base' });
  const onRow = (options && options.onRow) || (() => {});
  const body = document.createElement('tbody');
  const rowElements = new Map();

  function add(row) {
    const tr = document.createElement('tr');
    for (const column of columns) {
      const td = document.createElement('td');
      if (column.number) td.className = 'number';
      if (column.cell) column.cell(td, row);
      else td.textContent = column.text ? column.text(row) : String(column.value(row));
      tr.appendChild(td);
    }
    onRow(tr, row);
    rowElements.set(row, tr);
    body.appendChild(tr);
  }
  function fill(upTo) {
    while (rowElements.size < Math.min(upTo, rows.length)) add(rows[rowElements.size]);
  }
  fill(options && options.isLong ? 200 : rows.length);
  if (rowElements.size < rows.length) {
    const watch = new IntersectionObserver((seen) => {
      if (!seen.some((one) => one.isIntersecting)) return;
      watch.disconnect();
      fill(rowElements.size + 200);
      if (rowElements.size < rows.length) watch.observe(body.lastElementChild);
    });
    watch.observe(body.lastElementChild);
    window.addEventListener('beforeprint', () => fill(rows.length));
  }

  function compare(column, a, b) {
    const first = column.value(a);
    const second = column.value(b);
    if (!column.number) return collator.compare(first, second);
    const rank = (value) => (typeof value === 'number' && isFinite(value) ? value : -Infinity);
    return rank(first) === rank(second) ? 0 : rank(first) - rank(second);
  }

  const headRow = document.createElement('tr');
  for (const column of columns) {
    const th = document.createElement('th');
    th.scope = 'col';
    if (column.number) th.className = 'number';
    if (column.value) {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = column.label;
      button.addEventListener('click', () => {
        fill(rows.length);
        const isAscending = th.getAttribute('aria-sort') === 'ascending';
        for (const other of headRow.children) other.removeAttribute('aria-sort');
        th.setAttribute('aria-sort', isAscending ? 'descending' : 'ascending');
        const sorted = rows.slice().sort((a, b) => compare(column, a, b) * (isAscending ? -1 : 1));
        for (const row of sorted) body.appendChild(rowElements.get(row));
      });
      th.appendChild(button);
    } else {
      th.textContent = column.label;
    }
    headRow.appendChild(th);
  }
  const head = document.createElement('thead');
  head.appendChild(headRow);
  table.append(head, body);
  return {
    rows: rowElements,
    filter(predicate) {
      let shown = 0;
      for (const [row, tr] of rowElements) {
        tr.hidden = !predicate(row);
        if (!tr.hidden) ++shown;
      }
      return shown;
    },
  };
}
