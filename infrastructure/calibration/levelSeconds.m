% LEVELSECONDS  What a run costs at each level, as the runs so far tell.
%
% CALL: SECONDS = levelSeconds (BOOK, LEVELS)
%
%   BOOK     n x (v + 1): level variables of a set that was run, core-seconds;
%            may be empty
%   LEVELS   L x v
%   SECONDS  1 x L, mean of each level; where a level has no run yet, along the
%            straight line of its logarithm through the others; [] where no
%            level has a run
%
% See also: chooseLevels, newEvaluate

function seconds = levelSeconds (book, levels)
  L = rows (levels);
  v = columns (levels);
  seconds = NaN (1, L);
  for k = 1:L * ~isempty (book)
    seconds(k) = mean (book(all (book(:, 1:v) == levels(k, :), 2), end));
  end
  known = find (isfinite (seconds));
  if isempty (known)
    seconds = [];
    return
  end
  law = polyfit (known, log (seconds(known)), min (1, numel (known) - 1));
  lost = setdiff (1:L, known);
  seconds(lost) = exp (polyval (law, lost));
end

%!assert (levelSeconds ([], [3; 2; 1]), []);
%!assert (levelSeconds ([3, 1; 3, 3; 1, 18], [3; 2; 1]), [2, 6, 18], 1e-9);
%!assert (levelSeconds ([2, 5], [3; 2; 1]), [5, 5, 5], 1e-9);
