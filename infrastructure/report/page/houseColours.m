% HOUSECOLOURS  The colours of all figures, safe for the colour-blind.
%
% CALL: C = houseColours ()
%
%   C  scalar struct, colour as '#rrggbb' by name. page.css holds a variable of
%      the same name for each, in a light and in a dark form: drawFigures puts
%      the variables in the place of the colours
%
% The strong ones are those of Okabe and Ito (2008).

function c = houseColours ()
  c = struct ('ink', '#1b1f24', 'axis', '#57606a', 'grid', '#e4e7ea', ...
              'blue', '#0072b2', 'red', '#d55e00', 'green', '#009e73', ...
              'pink', '#cc79a7', 'sky', '#56b4e9', 'amber', '#e69f00', ...
              'grey', '#8c959f', 'paleblue', '#d3e5f2', ...
              'midblue', '#a9cde6', 'palegreen', '#cdeadf', ...
              'palegrey', '#e9ecef', 'palered', '#f7dcc8');
end

%!test
%! % each has its variable in the style sheet, for light and for dark
%! css = fileread (fullfile (fileparts (which ('houseColours')), 'page.css'));
%! for name = fieldnames (houseColours ())'
%!   assert (numel (strfind (css, ['--', name{1}, ':'])), 2);
%! end
