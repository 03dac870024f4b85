% SAYGAPCASE  Says what a diagnosis starts from.
%
% CALL: sayGapCase (CASE, DATA, COUNT, NOTES, SAY)
%
%   CASE   see newCase;  DATA, COUNT  of gatherRuns;  NOTES  of gapProblemOf
%   SAY    function handle that takes one line of text
%
% See also: diagnoseGap

function sayGapCase (Case, data, count, notes, say)
  say ('');
  say (sprintf ('diagnoseGap: %s', Case.folder));
  say (sprintf ('  models: %s', strjoin ({Case.models.name}, ', ')));
  names = {};
  if ~isempty (Case.effects)
    names = {Case.effects.name};
  end
  say (sprintf ('  candidate effects: %s', strjoin (names, ', ')));
  say (sprintf (['  runs: %d from the store, %d rows from runs.csv, %d ' ...
                 'sets in all'], count.store, count.imported, rows (data.X)));
  if ~isempty (count.ignored)
    say (['  columns of runs.csv that are not understood: ', ...
          strjoin(count.ignored, ', ')]);
  end
  for k = 1:numel (notes)
    say (['  note: ', notes{k}]);
  end
end
