% PAGENUMBER  A number of one of the case's files, as HTML.
%
% CALL: HTML = pageNumber (PAGE, KIND, SOURCE, STEP, ...)
%
%   PAGE    see pageData
%   KIND    see numberText
%   SOURCE  field of PAGE.sources (text): 'calibration', 'gap', ...
%   STEP    field names and indices that lead to the number
%   HTML    a data element that holds the full value and where it is from:
%           all numbers of the report are shown through this function; of an
%           array of two numbers, both, as an interval

function html = pageNumber (page, kind, source, varargin)
  x = jsonAt (page.sources, [{source}, varargin]);
  if isempty (x) || ~isnumeric (x) || ~isfinite (x(1)) || ...
     (numel (x) == 2 && ~isfinite (x(2)))
    html = '<span class="none">&ndash;</span>';
    return
  elseif numel (x) == 2
    html = [pageNumber(page, kind, source, varargin{:}, 1), ' to ', ...
            pageNumber(page, kind, source, varargin{:}, 2)];
    return
  end
  steps = cellfun (@num2str, varargin, 'UniformOutput', false);
  html = sprintf (['<data value="%.17g" data-kind="%s" ', ...
                   'data-from="%s">%s</data>'], x(1), kind, ...
                  htmlText (strjoin ([{source}, steps], '/')), ...
                  numberText (x(1), kind));
end

%!test
%! page.sources.calibration = struct ('a', struct ('b', [1, 0.25]));
%! html = pageNumber (page, 'percent', 'calibration', 'a', 'b', 2);
%! assert (html, ['<data value="0.25" data-kind="percent" ', ...
%!                'data-from="calibration/a/b/2">25&thinsp;%</data>']);
%! assert (pageNumber (page, 'plain', 'gap', 'x'), ...
%!         '<span class="none">&ndash;</span>');
%! page.sources.calibration.a.b = [1, 2];
%! html = pageNumber (page, 'plain', 'calibration', 'a', 'b');
%! assert (regexprep (html, '<[^>]*>', ''), '1 to 2');
%! page.sources.calibration.a.b = [1, NaN];
%! html = pageNumber (page, 'plain', 'calibration', 'a', 'b');
%! assert (regexprep (html, '<[^>]*>', ''), '&ndash;');
