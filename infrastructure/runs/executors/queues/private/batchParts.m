% BATCHPARTS  Which runs go to a queue as one job array.
%
% CALL: PARTS = batchParts (PICKS, JOBS, CASE, OPT)
%
%   PICKS       1 x k indices into JOBS
%   JOBS, CASE  see batchExecute
%   OPT         see newQueue, with arraySize: the most tasks of an array
%   PARTS       1 x n cell of parts of PICKS: each with models of the same CPUs

function parts = batchParts (picks, jobs, Case, opt)
  parts = cell (1, 0);
  [~, k] = ismember ({jobs(picks).model}, {Case.models.name});
  cpus = [Case.models(k).cpu];
  for cpu = unique (cpus)
    same = picks(cpus == cpu);
    for first = 1:opt.arraySize:numel (same)
      last = min (numel (same), first + opt.arraySize - 1);
      parts{end + 1} = same(first:last);
    end
  end
end

%!test
%! Case.models = struct ('name', {'A', 'B', 'C'}, 'cpu', {2, 1, 2});
%! jobs = struct ('model', {'A', 'B', 'C', 'A', 'B'});
%! assert (batchParts ([1, 2, 3, 4, 5], jobs, Case, struct ('arraySize', 2)), ...
%!         {[2, 5], [1, 3], 4});

% SPDX-License-Identifier: GPL-3.0-only
