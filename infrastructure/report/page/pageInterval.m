% PAGEINTERVAL  Two numbers of one of the case's files, as HTML: from, to.
%
% CALL: HTML = pageInterval (PAGE, KIND, SOURCE, STEP, ...)
%
%   as pageNumber; the path leads to an array of two numbers
%
% See also: pageNumber

function html = pageInterval (page, kind, varargin)
  both = jsonAt (page.sources, varargin);
  html = '<span class="none">&ndash;</span>';
  if numel (both) == 2 && isnumeric (both) && all (isfinite (both))
    html = [pageNumber(page, kind, varargin{:}, 1), ' to ', ...
            pageNumber(page, kind, varargin{:}, 2)];
  end
end

%!test
%! page.sources.a = struct ('b', [1, 2], 'c', [NaN, 1]);
%! html = regexprep (pageInterval (page, 'plain', 'a', 'b'), '<[^>]*>', '');
%! assert (html, '1 to 2');
%! html = regexprep (pageInterval (page, 'plain', 'a', 'c'), '<[^>]*>', '');
%! assert (html, '&ndash;');
