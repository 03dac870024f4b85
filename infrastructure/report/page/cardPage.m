% CARDPAGE  The page of a material card: values, evidence, tests.
%
% CALL: HTML = cardPage (ROOT, CARD)
%
%   ROOT  folder of the toolbox (text);  CARD  see materialCard
%   HTML  one file (text)

function html = cardPage (root, card)
  page = struct ('sources', struct ());
  T = newTable (page, 'values', 'Values of the material, and the evidence for each', ...
                {'value of', '', 'name'; 'value', '', 'plain'; ...
                 '90 % interval', '', 'plain'; 'evidence', '', 'words'}, ...
                eachOf (@valueRow, card.values));
  tests = newTable (page, 'tests', 'Measurements behind them', ...
                    {'result', '', 'name'; 'test rig', '', ''; 'case', '', ''; ...
                     'measured', '', 'plain'; 'simulated', '', 'plain'; '', '', ''}, ...
                    eachOf (@testRow, card.tests));
  lines = eachOf (@(c) [c.name, ' (', strjoin(c.models, ', '), '): ', ...
                        resultTitle(c, c.date)], card.cases);
  items = strcat ('<li>', htmlText (lines), '</li>');
  html = plainPage (root, 'Material card', strjoin (card.material, ', '), ...
                    [tableHtml(T), tableHtml(tests), '<h2>Cases</h2><ul>', items{:}, ...
                     '</ul>']);
end

function cells = valueRow (v)
  name = struct ('value', givenField (v, 'label', v.name), 'code', v.name, 'unit', v.unit);
  [class, text] = evidence (v);
  cells = {name, v.value, v.interval, struct('value', text, 'class', class)};
end

function cells = testRow (t)
  role = repmat (' (not fitted)', 1, strcmp (t.role, 'holdout'));
  cells = {struct('value', [t.name, role], 'unit', t.unit), t.model, t.case, ...
           struct('value', numberOf (t.target), 'sd', numberOf (t.sd)), ...
           struct('value', numberOf (t.result), 'sd', numberOf (t.resultSd)), t.state};
end

function x = numberOf (x)
  if ~isnumeric (x) || isempty (x)
    x = NaN;
  end
end

function [class, text] = evidence (v)
  class = 'unsure';
  switch v.from
    case 'given'
      text = sprintf ('given by the user in %s', v.case);
      return
    case 'model'
      text = sprintf ('as the model of %s has it: nobody measured it', v.case);
      return
  end
  word = merge (v.confirmed || ~v.determined, 'calibrated', 'fitted, not confirmed');
  text = sprintf ('%s in %s (%s)', word, v.case, ...
                  strjoin (v.models, ', '));
  if ~isempty (v.by)
    text = [text, ', seen by ', strjoin(v.by, ', ')];
  end
  if ~v.determined
    text = [text, ', but these tests do not determine it'];
  end
  others = cellfun (@(o) sprintf ('%s: %.4g', o.case, o.value), v.others, ...
                    'UniformOutput', false);
  if ~isempty (others)
    text = [text, '; also ', strjoin(others, ', ')];
  end
  if isequal (v.agrees, false)
    class = 'off';
    text = [text, '. The intervals do not overlap'];
  elseif v.confirmed
    class = 'ok';
  end
end

% SPDX-License-Identifier: GPL-3.0-only
