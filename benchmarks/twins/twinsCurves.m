% TWINSCURVES  Figures of merit of the twin study over the signal to noise d.
%
% CALL: twinsCurves (NAME, PICTURE, LEVELS)
%
%   NAME     path without ending: NAME.csv (of twinsScore) is read,
%            NAME-curves.csv written (figure, d, hits, cases, share, lo95, hi95)
%   PICTURE  path of an SVG file; empty or missing: none
%   LEVELS   1 x m, signals to noise; cases are gathered around the nearest one
%            (1, 2, 3, 4, 6, 8)
%
% The intervals are Clopper and Pearson's. Log and Brier score are means over
% the cases with one cause on the list, with 95 % intervals of the mean.
%
% See also: twins, twinsScore, binomialInterval

function twinsCurves (name, picture, levels)
  if nargin < 3
    levels = [1, 2, 3, 4, 6, 8];
  end
  cases = readCases ([name, '.csv']);
  [~, near] = min (abs (levels - cases.d), [], 2);
  isSingle = strcmp (cases.class, 'single');
  figures = figuresOf (cases, isSingle);
  table = zeros (rows (figures), numel (levels), 5);
  for f = 1:rows (figures)
    for l = 1:numel (levels)
      at = figures{f, 3} & near == l;
      k = sum (figures{f, 2} & at);
      [lo, hi] = binomialInterval (k, sum (at));
      table(f, l, :) = [k, sum(at), k / max(sum (at), 1), lo, hi];
    end
  end
  names = figures(:, 1);
  nShares = numel (names);
  for kind = {'logScore', 'brier'}
    f = rows (table) + 1;
    names{f} = struct ('logScore', 'log score (prior -3.2)', ...
                       'brier', 'Brier score (prior 1.1)').(kind{1});
    for l = 1:numel (levels)
      table(f, l, :) = meanOf (cases.(kind{1})(isSingle & near == l));
    end
  end
  writeTable ([name, '-curves.csv'], names, levels, table);
  if nargin > 1 && ~isempty (picture)
    draw (picture, names, levels, table, nShares);
  end
end

function figures = figuresOf (cases, isSingle)
  out = ismember (cases.class, {'out', 'off', 'look'});
  named = strcmp (cases.verdict, 'named');
  said = named | strcmp (cases.verdict, 'group');
  noGap = strcmp (cases.verdict, 'no gap');
  figures = {'a gap was seen', ~strcmp(cases.verdict, 'no gap'), isSingle; ...
             'likeliest one is the true one', cases.isTop, isSingle; ...
             'named or grouped rightly', cases.right, isSingle; ...
             'named', named, isSingle; ...
             'names that are right', cases.right, isSingle & named; ...
             'strength in its 90 % interval', cases.covered, isSingle; ...
             'not listed: none of the listed', ...
             strcmp(cases.verdict, 'none of the listed'), out; ...
             'not listed: wrong name', named, out; ...
             'grouped', said & ~named, isSingle; ...
             'abstained', ~(said | noGap), isSingle; ...
             'odds of the right one > 20', cases.odds20, isSingle; ...
             'odds > 20: named or grouped', said, isSingle & cases.odds20};
end

function cases = readCases (file)
  [header, words] = readCsvTable (file);
  column = @(title) words(:, strcmp (header, title));
  number = @(title) str2double (column (title));
  cases = struct ('class', {column('class')}, 'verdict', {column('verdict')});
  cases.d = number ('d');
  cases.right = number ('right') > 0;
  cases.covered = number ('covered') > 0;
  cases.odds20 = number ('odds20') > 0;
  cases.logScore = number ('logScore');
  cases.brier = number ('brier');
  cases.isTop = strcmp (column ('top'), column ('cause'));
end

% Mean with its 95 % interval, in the shape of a share: cases, cases, mean, lo,
% hi.
function row = meanOf (x)
  n = numel (x);
  half = 1.96 * std (x) / sqrt (max (n, 1));
  row = [n, n, mean(x), mean(x) - half, mean(x) + half];
end

function writeTable (file, names, levels, table)
  fid = fopen (file, 'w');
  fprintf (fid, "figure,d,hits,cases,share,lo95,hi95\n");
  for f = 1:numel (names)
    for l = 1:numel (levels)
      fprintf (fid, "%s,%d,%d,%d,%.4f,%.4f,%.4f\n", names{f}, levels(l), ...
               table(f, l, :));
    end
  end
  fclose (fid);
end

function draw (file, names, levels, table, nShares)
  for k = 1:numel (names)
    has = squeeze (table(k, :, 2)) > 0;
    unit = 1 + 99 * (k <= nShares);
    part = unit * reshape (table(k, has, 3:5), [], 3)';
    curve = struct ('x', levels(has), 'y', part(1, :), 'lo', part(2, :), ...
                    'hi', part(3, :));
    panels(k) = struct ('title', names{k}, 'xlabel', 'd', 'ylabel', '%', ...
                        'range', [0, max(levels) + 1, 0, 100], ...
                        'band', [], 'curves', curve);
    if k > nShares
      panels(k).ylabel = '';
      panels(k).range(3:4) = NaN;
    end
  end
  drawPanels (file, panels, 5, {});
end

%!test % two single cases near d = 4, one of them named rightly
%! name = tempname ();
%! fid = fopen ([name, '.csv'], 'w');
%! fputs (fid, ["class,cause,d,verdict,top,right,covered,odds20,", ...
%!              "logScore,brier\nsingle,a,4.1,named,a,1,1,1,-0.1,0.1\n", ...
%!              "single,b,3.9,no gap,a,0,1,0,-3,0.9\n"]);
%! fclose (fid);
%! twinsCurves (name);
%! text = fileread ([name, '-curves.csv']);
%! delete ([name, '.csv'], [name, '-curves.csv']);
%! assert (~isempty (strfind (text, 'named or grouped rightly,4,1,2,0.5000')));
%! assert (~isempty (strfind (text, 'names that are right,4,1,1,1.0000')));
%! assert (~isempty (strfind (text, 'odds of the right one > 20,4,1,2,0.5')));
%! assert (~isempty (strfind (text, 'abstained,4,0,2,0.0000')));
