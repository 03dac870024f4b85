% RELIABILITY  How often the likeliest effect is true, by its stated probability.
%
% CALL: octave-cli benchmarks/reliability.m CSV NAME=TABLE[+TRUTH] ...
%
%   CSV    file to write: name, bin, cases, mean stated probability, hits, share
%          with its 95 % Clopper-Pearson interval; printed too
%   NAME   what the tables of one curve are called, once before each
%   TABLE  in results/: case, top, pTop, gateP or p, and class and cause where no
%          TRUTH (a table with case, class, cause) holds them
%
% The figures of docs/gap-figures.md: before=leftOut-hiddenEffect.csv
% before=leftOut-drumAndBins.csv before=blind-answers.csv+blind-truth.csv
% before=blindbins-answers.csv+blindbins-truth.csv before=foreign-blind.csv
% formAfter=form-after.csv
%
% Counted are cases with a gap and an alarm (p below 0.05). A cause that is off
% the list, or another law of one that was left out, is never the likeliest
% effect.
%
% See also: formStudy, leftOut, blind

1;

function list = casesOf (words, folder)
  files = strsplit (words, '+');
  list = tableRows (fullfile (folder, files{1}));
  if numel (files) > 1
    truth = tableRows (fullfile (folder, files{2}));
    [~, at] = ismember ({list.case}, {truth.case});
    [list.class] = truth(at).class;
    [list.cause] = truth(at).cause;
  end
end

function [stated, isRight] = statedOf (list)
  field = 'p';
  if isfield (list, 'gateP')
    field = 'gateP';
  end
  counts = cellfun (@str2double, {list.(field)}) < 0.05 & ~strcmp ({list.class}, 'null');
  list = list(counts);
  stated = cellfun (@str2double, {list.pTop});
  isListed = ismember ({list.class}, {'single', 'pair'});
  isRight = isListed & cellfun (@(top, cause) ...
                                any (strcmp (top, strsplit (cause, ' '))), ...
                                {list.top}, {list.cause});
end

function lines = curveOf (name, stated, isRight)
  edges = [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.97, 1.001];
  lines = {};
  for i = 1:numel (edges) - 1
    in = stated >= edges(i) & stated < edges(i + 1);
    [k, n] = deal (sum (isRight(in)), sum (in));
    [lo, hi] = binomialInterval (k, n);
    lines{end + 1} = sprintf ('%s,%.2f,%.2f,%d,%.3f,%d,%.3f,%.3f,%.3f', ...
                              name, edges(i), min (edges(i + 1), 1), n, ...
                              mean ([stated(in), NaN(1, n == 0)]), k, ...
                              k / max (n, 1), lo, hi);
  end
end

addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
words = argv ();
names = {};
tables = struct ('stated', {}, 'isRight', {});
for word = words(2:end)'
  parts = strsplit (word{1}, '=');
  list = casesOf (parts{2}, fullfile (root, 'benchmarks', 'results'));
  at = find (strcmp (names, parts{1}));
  if isempty (at)
    names{end + 1} = parts{1};
    tables(end + 1) = struct ('stated', [], 'isRight', []);
    at = numel (names);
  end
  [stated, isRight] = statedOf (list);
  tables(at).stated = [tables(at).stated, stated];
  tables(at).isRight = [tables(at).isRight, isRight];
end
lines = {'name,from,to,cases,stated,hits,share,lo95,hi95'};
for i = 1:numel (names)
  lines = [lines, curveOf(names{i}, tables(i).stated, tables(i).isRight)];
end
writeAtomic (words{1}, [strjoin(lines, "\n"), "\n"]);
printf ('%s\n', lines{:});
