% IMPORTEXISTING  Takes in the runs of a table runs.csv in the case folder.
%
% CALL: DATA = importExisting (CASE, SAY)
%
%   CASE  see newCase
%   SAY   function handle that takes one line of text
%   DATA  see newData, E the levels of CASE.coarse; empty where there is no
%         runs.csv. Rows with an effect switched on are left out: they belong to
%         the diagnosis
%
% See also: importRuns, diagnoseGap

function data = importExisting (Case, say)
  v = numel (Case.coarse);
  data = newData (numel (Case.names), numel (Case.targets), v);
  file = fullfile (Case.folder, 'runs.csv');
  if ~isfile (file)
    return
  end
  Case = withEffects (Case);
  [found, ignored] = importRuns (file, Case);
  isOn = found.E ~= neutralEffects (Case);
  isPlain = ~any (isOn(:, v + 1:end), 2);
  data = addRows (data, found.X(isPlain, :), found.Z(isPlain, :), ...
                  found.replicate(isPlain), 'import', found.E(isPlain, 1:v));
  say (sprintf ('runs.csv: %d runs taken in, %d with an effect left aside', ...
                sum (isPlain), sum (~isPlain)));
  if ~isempty (ignored)
    say (sprintf ('  WARNING: columns that the case does not know: %s', ...
                  strjoin (ignored(:)', ', ')));
  end
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! quiet = @(text) [];
%! assert (size (importExisting (Case, quiet).X), [0, 2]);
%! writeAtomic (fullfile (Case.folder, 'runs.csv'), ...
%!   ["model,seed,a,b,First_1,First_2,Second_1\n", ...
%!    "First,1,1,2,3,2,\nSecond,1,1,2,,,-1\n"]);
%! data = importExisting (Case, quiet);
%! assert (data.X, [1, 2]);
%! assert (data.Z, [3, 2, -1]);
