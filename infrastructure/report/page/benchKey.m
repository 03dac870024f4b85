% BENCHKEY  What the symbols of benchFigure mean, as HTML.
%
% CALL: HTML = benchKey (PAGE)
%
%   PAGE  see pageData
%
% See also: benchFigure

function html = benchKey (page)
  entries = {'line', 'ink', 'measured'; 'box', 'palegreen', 'allowed'; ...
             'box', 'palegrey', 'what the box of the parameters reaches'; ...
             'diamond', 'blue', 'simulated with the set'};
  if ~isempty (jsonAt (page.sources.gap, {'howFar', 'targets'}))
    effect = jsonAt (page.sources.gap, {'howFar', 'effect'});
    entries(end + 1, :) = {'triangle', 'amber', ...
                           ['fitted with ', htmlText(effect)]};
  end
  if isfield (page.Case.targets, 'each')
    entries(end + 1, :) = {'dots', 'ink', 'your trials'};
  end
  html = htmlKey (entries);
end
