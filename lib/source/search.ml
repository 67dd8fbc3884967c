let last_from start items offset =
  let rec between low high =
    if low = high then low
    else
      let middle = (low + high + 1) / 2 in
      if start items.(middle) <= offset then between middle high
      else between low (middle - 1)
  in
  between 0 (Array.length items - 1)
