% REPORTCOST  Says and writes the best set known of a case of one cost.
%
% CALL: RESULT = reportCost (CASE, SAY)
%
%   CASE    see newCase (isCost)
%   SAY     function handle that takes one line of text, or with it the class of a
%           verdict, see sayLine
%   RESULT  see bestKnown, with exitStatus 2: nothing is confirmed
%
% Writes results/best.json (RESULT), best.head (lines of a data.head) and the page.

function b = reportCost (Case, say)
  b = bestKnown (Case);
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  writeAtomic (fullfile (folder, 'best.json'), [jsonencode(b), "\n"]);
  values = assignParams (Case.modelVars, cellfun (@(n) b.params.(n), Case.names), ...
                         Case.names);
  writeAtomic (fullfile (folder, 'best.head'), ...
               ['# ', resultTitle(b, b.date), "\n", headLines(values)]);
  [T, texts] = costTable (Case, b);
  cellfun (say, tableText (T), 'UniformOutput', false);
  say ('');
  say (['BEST SET KNOWN: ', sprintf('smallest %s %.5g, of %s', b.name, b.cost, ...
                                    countText (b.sets, 'set'))], 'open');
  cellfun (@(text) say (['  ', text]), texts, 'UniformOutput', false);
  if exist ('costPage', 'file') == 2           % a wing, page/
    say (['Report: ', costPage(Case, b)]);
  end
  b.exitStatus = 2;
end

% SPDX-License-Identifier: GPL-3.0-only
