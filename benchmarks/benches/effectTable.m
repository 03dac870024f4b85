% EFFECTTABLE  Turns the measured signs into a table for the documentation.
%
% CALL: TEXT = effectTable (FILE)
%
% FILE  text, effectSigns.csv of effectSigns
% TEXT  Markdown: a table for each bench, one row an effect, one column a
%       target; an entry is the sign and the change in noise standard
%       deviations of one run; 0 where the change is not told from zero
%
% See also: effectSigns
function text = effectTable (file)
  [~, words] = readCsvTable (file);
  text = '';
  for bench = unique (words(:, 3), 'stable').'
    own = words(strcmp (words(:, 3), bench{1}), :);
    targets = setdiff (unique (own(:, 4), 'stable'), {'none'}, 'stable');
    text = [text, sprintf("### %s\n\n| effect | strength |", bench{1}), ...
            sprintf(' %s |', targets{:}), sprintf("\n|---|---|"), ...
            repmat('---|', 1, numel (targets)), sprintf("\n")];
    for effect = unique (own(:, 1), 'stable').'
      text = [text, tableRow(own(strcmp (own(:, 1), effect{1}), :), targets)];
    end
    text = [text, sprintf("\n")];
  end
end

function text = tableRow (rows, targets)
  text = sprintf ('| %s | %s |', rows{1, 1}, rows{1, 2});
  for target = targets(:).'
    k = find (strcmp (rows(:, 4), target{1}), 1);
    if isempty (k)
      text = [text, ' failed |'];
    elseif strcmp (rows{k, 8}, '0')
      text = [text, ' 0 |'];
    else
      text = [text, sprintf(' %s %.1f |', rows{k, 8}, ...
                            abs (str2double (rows{k, 7})))];
    end
  end
  text = [text, sprintf("\n")];
end

%!test % two targets, one moved, one not
%! file = tempname ();
%! fid = fopen (file, 'w');
%! fputs (fid, ["e,s,b,t,c,n,z,g\ntilt,2,Drum,slope,1,0.2,5,+\n", ...
%!              "tilt,2,Drum,size,0,1,0,0\n"]);
%! fclose (fid);
%! text = effectTable (file);
%! delete (file);
%! assert (~isempty (strfind (text, '| tilt | 2 | + 5.0 | 0 |')));
